// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

struct FontState;

// A font file that was read. Not for several threads at once.
class Font {
public:
    static constexpr std::size_t most_bytes = std::size_t(256) << 20;
    // `face` as fontconfig counts: of a collection, in its upper half the named instance. Throws
    // Rejected, with `name` in the sentence, for what is no TrueType or OpenType outline font.
    Font(std::string bytes, int face, const std::string& name);
    ~Font();
    Font(Font&&) noexcept;

    struct Glyph {
        Region loops;          // as the font has them: they may overlap
        bool even_odd = false; // what is inside
        bool damaged = false;  // what the file says is no outline, or more than 10,000 points
    };
    // Curves become chords within `tolerance` units.
    Glyph glyph(unsigned index, double tolerance) const;

    static constexpr int box_width = em_units * 6 / 10; // of what the font has no glyph for
    struct PlacedGlyph {
        unsigned glyph = 0; // 0: none
        glm::ivec2 at{0};   // units from where the line begins
        std::size_t letter; // the first one in the line that it stands for
    };
    struct Line {
        std::vector<PlacedGlyph> glyphs; // from left to right
        int width = 0;                   // units
    };
    // One line of letters as they are read: runs of one direction [1] and script, shaped by the
    // font's tables, `spacing` units more after each letter. Without `spacing` ligatures are taken.
    //   [1] Unicode Standard Annex 9, the bidirectional algorithm
    Line line(std::u32string_view letters, int spacing) const;

    bool has(char32_t letter) const;   // a glyph of its own
    double line_height() const;        // em, from one base line to the next
    const std::string& title() const;  // its family and style
    const std::string& digest() const; // of the file and the face

private:
    std::unique_ptr<FontState> state_;
};

} // namespace trivar
