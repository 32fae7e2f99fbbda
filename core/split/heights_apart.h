// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace trivar {

// An edge of which one end is above a cut and the other below it: a height not negative, and one
// that is, at two points of a mesh.
struct CrossedEdge {
    std::array<std::uint32_t, 2> points;
    std::array<double, 2> heights;
};

// Moves heights away from 0 until each is at least 2e-4 of that at the other end of its edge, the
// same way at every edge of a point. All places of a cut then lie on the zeros of one function that
// is linear along every edge: held on their edges one by one, those round a vertex could run back
// and forth over each other on a face that is parallel to the direction of the heights. Heights at
// one point are equal before and after. O(k log k).
void move_apart(std::span<CrossedEdge> edges);

} // namespace trivar
