// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A RimLoop is a closed way along directed edges: its places in their order.
using RimLoop = std::vector<std::uint32_t>;

struct RimLoops {
    std::vector<RimLoop> closed;
    std::vector<RimLoop> open; // where the mesh was open: from one end to the other
};

// The loops of directed edges between `places` places. Where several edges leave a place the first
// one is taken. O(#edges).
RimLoops loops_of(const std::vector<glm::uvec2>& edges, std::size_t places);

// Open ways made loops: from the end of each the next one is that which begins nearest, itself
// included, until the first is reached again. Ways that would have to go across gaps for more than
// a fifth of the loop, as those of a sheet, stay open and are left out. O(#ways^2).
std::vector<RimLoop> joined_ways(const std::vector<RimLoop>& ways,
                                 const std::vector<glm::dvec2>& places);

// Loops that belong together: one that runs counter-clockwise, and those clockwise ones that lie in
// it and in no smaller one. Loops by number. O(#loops x #points).
std::vector<std::vector<std::size_t>> nested(const std::vector<RimLoop>& loops,
                                             const std::vector<glm::dvec2>& places);

} // namespace trivar
