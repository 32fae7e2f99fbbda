// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace trivar::gpu {

// TileCounts say how much of a picture's tiles is drawn.
struct TileCounts {
    std::size_t tiles = 0, drawn = 0;           // number of tiles, and of those that are seen
    std::size_t hidden = 0;                     // in view, but behind something
    std::size_t vertices = 0, all_vertices = 0; // as they are drawn once, and of all at full detail
    std::vector<std::size_t> by_level;          // of those that are drawn, from the finest on
    std::size_t outside() const { return tiles - drawn - hidden; } // of the view

    // Adds tiles that are drawn by a level.
    void add(std::size_t level, std::size_t count, std::size_t vertices_each)
    {
        if (count == 0) return;
        if (by_level.size() <= level) by_level.resize(level + 1);
        by_level[level] += count;
        drawn += count;
        vertices += count * vertices_each;
    }
    bool operator==(const TileCounts&) const = default;
};

} // namespace trivar::gpu
