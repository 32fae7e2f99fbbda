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
        field("text", s.text, "the letters; line breaks begin new lines");
        field("font", s.font, "family, family and style, or a font file; docs/text.md");
        field("font_digest", s.font_digest, "of the font file that was meant; empty: any");
        field("size", s.size, "of an em, metres", positive.in(Unit::metres));
        field("depth", s.depth, "metres, at most 20 sizes", positive.in(Unit::metres));
        field("bevel", s.bevel, "how far front and back draw in, metres; 0.45 of the depth counts",
              not_negative.in(Unit::metres));
        field("bevel_steps", s.bevel_steps, "1: a flat chamfer; more: round", in_range(1, 16));
        field("tolerance", s.tolerance, "that chords may be from curves, part of the size",
              in_range(1e-4, 0.1));
        field("max_edge", s.max_edge, "that edges may be long, so that it bends, part of the size",
              in_range(0.01, 10).called("Longest edge"));
        field("letter_spacing", s.letter_spacing, "more after each letter, part of the size",
              in_range(-1, 10).called("Letter gap"));
        field("line_spacing", s.line_spacing, "from line to line, of what the font wants",
              in_range(-10, 10).called("Line gap"));
        field("align", s.align, "where lines have the origin");
    }
};

} // namespace trivar
