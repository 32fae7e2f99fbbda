// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// SeenSides counts the visible pixels of the two sides of a part of a mesh, in pictures of one
// scale.
struct SeenSides {
    std::uint64_t front = 0, back = 0;
};

// Counts which sides of the parts of a mesh are seen from far outside, in 14 directions all round,
// where all faces hide what is behind them. `part_of`: the part of each face. `box`: the region
// that is looked at, with 512 pixels along its diagonal. If two faces lie in one place, the front
// counts. O(#C) a direction; the same for any number of threads.
std::vector<SeenSides> seen_from_outside(const Mesh& mesh,
                                         const std::vector<std::uint32_t>& part_of,
                                         std::size_t parts, const Box& box);

} // namespace trivar
