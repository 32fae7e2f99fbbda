// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/text/font.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

enum class TextAlign { left, center, right };

// A TextShape is letters as bodies: the text reads along X, lines follow one another against Y, and
// the letters stand out of z = 0 by the depth.
struct TextShape {
    std::string text = "Text"; // UTF-8; line breaks begin new lines
    std::string font = "DejaVu Sans";
    std::string font_digest = {}; // of the intended font file; empty: any
    double size = 0.5;            // of an em, metres: about the distance of tightly set lines
    double depth = 0.1;           // metres
    double bevel = 0;             // metres; see Extrusion
    int bevel_steps = 4;
    double tolerance = 0.001;  // greatest distance of chords from curves, as a part of the size
    double max_edge = 0.1;     // greatest length of edges, as a part of the size
    double letter_spacing = 0; // added after each letter, as a part of the size
    double line_spacing = 1;   // from base line to base line, relative to the font's own
    TextAlign align = TextAlign::left;
    bool operator==(const TextShape&) const = default;
};

// Whether a text has letters other than spaces. Throws Rejected for bytes that are not UTF-8.
bool has_letters(const std::string& text);
// Throws Rejected for a text without letters or with more than 2000 of them, for control characters
// other than tabs and line breaks, for bytes that are not UTF-8, and for a depth above 20 sizes.
void check(const TextShape& shape);

// Ends the notice of a font whose file is not the one of the digest.
inline constexpr std::string_view other_font_words =
    " is another version than the scene was made with; letters may differ";

struct TextBody {
    Mesh mesh; // each letter is closed; letters without an outline are left out
    std::vector<std::string>
        notices; // letters that the font lacks and that are boxes, another file
};
// Throws Rejected as check(shape), and where there would be more than 4 million faces. O(#letters),
// and the cost of each different letter once.
TextBody text_body(const TextShape& shape, const Font& font);

} // namespace trivar
