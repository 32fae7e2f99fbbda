// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/text/font.h"

#include <string>
#include <vector>

namespace trivar {

enum class TextAlign { left, center, right };

// Letters as bodies: the text reads along X, lines follow one another against Y, and the letters
// stand out of z = 0 by the depth.
struct TextShape {
    std::string text = "Text"; // UTF-8; line breaks begin new lines
    std::string font = "DejaVu Sans";
    std::string font_digest = {}; // of the font file that was meant; empty: any
    double size = 0.5;            // of an em, metres: about the distance of tight lines
    double depth = 0.1;           // metres
    double bevel = 0;             // metres; see Extrusion
    int bevel_steps = 4;
    double tolerance = 0.001;  // that chords may be from curves, part of the size
    double max_edge = 0.1;     // that edges may be long, part of the size
    double letter_spacing = 0; // more after each letter, part of the size
    double line_spacing = 1;   // from base line to base line, of what the font wants
    TextAlign align = TextAlign::left;
    bool operator==(const TextShape&) const = default;
};

// Others than spaces. Throws Rejected for bytes that are no UTF-8.
bool has_letters(const std::string& text);
// Throws Rejected for a text without letters or with more than 2000 of them, for control characters
// other than tabs and line breaks, for bytes that are no UTF-8 and for more depth than 20 sizes.
void check(const TextShape& shape);

struct TextBody {
    Mesh mesh; // each letter closed; nothing of the letters that show nothing
    std::vector<std::string>
        notices; // letters that the font lacks and that are boxes, another file
};
// Throws Rejected as check(shape) and where it would have more than 4 million faces. O(#letters)
// and each different letter once.
TextBody text_body(const TextShape& shape, const Font& font);

} // namespace trivar
