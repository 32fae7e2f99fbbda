// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"

namespace trivar {

// A UvLine is the line on a surface through a place along which one texture coordinate stays.
struct UvLine {
    std::vector<SurfacePlace> places; // from end to end; empty: there are no coordinates
    std::size_t start = 0;            // which of them it goes through
};

// `coordinate`: 0: u stays, 1: v stays. It ends at a seam, at a border, and where it has come round
// to its beginning. O(#triangles that it goes through).
UvLine uv_line(const TileBase& base, const SurfacePlace& from, int coordinate);

} // namespace trivar
