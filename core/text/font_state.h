// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>
#include <string>

namespace trivar {

// What reads the outlines of a font and what reads its tables, over the same bytes.
struct FontState {
    std::string bytes, title, digest;
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    hb_font_t* shaper = nullptr;

    FontState() = default;
    ~FontState();
    FontState(const FontState&) = delete;
    FontState& operator=(const FontState&) = delete;
};

} // namespace trivar
