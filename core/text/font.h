// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

struct FontState;

// A Font is a font file that was read. Several threads must not use it at once.
class Font {
public:
    static constexpr std::size_t most_bytes = std::size_t(256) << 20;
    // `face` is fontconfig's number: the face of a collection, with the named instance in its upper
    // half. Throws Rejected, with `name` in the sentence, for a file that is no TrueType or
    // OpenType outline font.
    Font(std::string bytes, int face, const std::string& name);
    ~Font();
    Font(Font&&) noexcept;

    struct Glyph {
        Region loops;          // as the font has them; loops may overlap
        bool even_odd = false; // the rule that says what is inside
        bool damaged = false;  // the file holds no valid outline for it, or more than 10,000 points
    };
    // The outline of a glyph; curves become chords within `tolerance` units.
    Glyph glyph(unsigned index, double tolerance) const;

    static constexpr int box_width = em_units * 6 / 10; // of the box for letters without a glyph
    struct PlacedGlyph {
        unsigned glyph = 0; // 0: none
        glm::ivec2 at{0};   // units from where the line begins
        std::size_t letter; // the first letter of the line for which it stands
    };
    struct Line {
        std::vector<PlacedGlyph> glyphs; // from left to right
        int width = 0;                   // units
    };
    // Shapes one line of letters in reading order: runs of one direction [1] and script are shaped
    // by the font's tables, with `spacing` more units after each letter. Ligatures are used only
    // without `spacing`. [1] Unicode Standard Annex 9, the bidirectional algorithm
    Line line(std::u32string_view letters, int spacing) const;

    bool has(char32_t letter) const;   // whether the font has a glyph for it
    double line_height() const;        // em, from one base line to the next
    const std::string& title() const;  // its family and style
    const std::string& digest() const; // of the file and the face

private:
    std::unique_ptr<FontState> state_;
};

} // namespace trivar
