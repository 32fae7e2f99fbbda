// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace trivar::gpu {

// TileCounts say how much of a picture's tiles is drawn.
struct TileCounts {
    std::size_t tiles = 0, drawn = 0;           // number of tiles, and of those that are seen
    std::size_t vertices = 0, all_vertices = 0; // as they are drawn once, and of all at full detail
};

} // namespace trivar::gpu
