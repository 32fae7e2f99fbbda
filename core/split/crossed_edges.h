// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace trivar {

// A CrossedEdge is an edge that crosses a cut, by two points of a mesh: its heights at both ends,
// one >= 0 and one < 0.
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
