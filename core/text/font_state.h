// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>

namespace trivar {

// What reads the outlines of a font and what reads its tables, over the same bytes.
struct Font::State {
    std::string bytes, title, digest;
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    hb_font_t* shaper = nullptr;

    State() = default;
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

} // namespace trivar
