// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 3> choice_names<TextAlign>{"left", "center", "right"};
template <>
inline constexpr std::array<std::string_view, 3> choice_words<TextAlign>{"left", "centre", "right"};

template <> struct FieldsOf<TextShape> {
    static constexpr std::string_view verb = "add_text",
                                      summary = "Add letters as closed bodies. They read along X "
                                                "and stand out of z = 0.",
                                      name = "Text";
    static void fields(auto& s, auto&& field)
    {
        field("text", s.text, "the letters; line breaks begin new lines",
              any_value.names_nothing("letters"));
        field("font", s.font, "family, family and style, or a font file; docs/text.md",
              any_value.names_file(FileKind::font));
        field("font_digest", s.font_digest, "digest of the font file; empty: any",
              any_value.digest_of_file());
        field("size", s.size, "height of an em, metres", positive.in(Unit::metres));
        field("depth", s.depth, "metres, at most 20 sizes", positive.in(Unit::metres));
        field("bevel", s.bevel, "width of the bevel, metres; at most 0.45 of the depth",
              not_negative.in(Unit::metres));
        field("bevel_steps", s.bevel_steps, "1: a flat chamfer; more: round", in_range(1, 16));
        field("tolerance", s.tolerance,
              "how far the outline may be from its curves, as a share of the size",
              in_range(1e-4, 0.1));
        field("max_edge", s.max_edge,
              "the longest edge, as a share of the size; shorter edges bend better",
              in_range(0.01, 10).called("Longest edge"));
        field("letter_spacing", s.letter_spacing,
              "extra space after each letter, as a share of the size",
              in_range(-1, 10).called("Letter gap"));
        field("line_spacing", s.line_spacing,
              "distance from line to line, relative to that of the font",
              in_range(-10, 10).called("Line gap"));
        field("align", s.align, "which end of the lines is at the origin");
    }
};

} // namespace trivar
