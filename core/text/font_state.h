// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>
#include <string>

namespace trivar {

// A FontState holds the reader of a font's outlines and the reader of its tables, over the same
// bytes.
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
