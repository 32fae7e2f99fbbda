// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace trivar {

// Closed loops on a grid that may cross, cut at all crossings. The area that they run round n times
// is in layers 1 to n, or -1 to -n where they run round it clockwise. Each step between two points
// borders one layer: one above 0 on its left, one below 0 on its right. Steps that others go back
// are in layer 0. In each layer as many steps come to a point as leave it.
struct LoopLayers {
    struct Step {
        std::uint32_t from, to;
        int layer;
    };
    std::vector<glm::ivec2> points;
    std::vector<std::vector<Step>>
        edges; // the way of each edge of the loops, one loop after another
};

// Crossings are rounded to the grid until none is left. None: that did not end, or there is too
// much of it. O(n^2) for n steps. Coordinates are at most 2^29.
std::optional<LoopLayers> layers_of(const std::vector<std::vector<glm::ivec2>>& loops);

} // namespace trivar
