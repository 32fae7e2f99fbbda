// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

#include <span>

namespace trivar {

// Returns the smallest ratio of knot simplex volume to cell volume around a vertex. A knot simplex
// takes one knot of the cloud of each corner, with numbers that sum to the degree at most. Below 0
// clouds cross: the spline has no basis then. 1: all clouds are stacked.
//   cells_round  the cells round the vertex; O(their number)
double cloud_room(const SimplexDomain<3>& domain, std::span<const int> cells_round);

// Returns the greatest share, 0..1, of the movement of one knot such that no lesser share leaves a
// knot simplex less than `least_room` of its cell, or less than it has where that is less.
//   knot  1 .. degree, of the vertex
//   by    the movement, space of the domain
// Exact, for a simplex's volume is linear in one of its corners.
inline constexpr double least_room = 0.05;
double allowed_share(const SimplexDomain<3>& domain, std::span<const int> cells_round, int vertex,
                     int knot, const glm::dvec3& by);

// Returns the region, as far as `reach` from the vertex along each axis, in which one knot of a
// vertex keeps the simplices that large: a convex body, by its plane faces, each anticlockwise from
// outside. About 1 ms.
std::vector<std::vector<glm::dvec3>> knot_region(const SimplexDomain<3>& domain,
                                                 std::span<const int> cells_round, int vertex,
                                                 int knot, double reach);

// The cells round a vertex, ascending. O(number of cells).
std::vector<int> cells_round(const SimplexDomain<3>& domain, int vertex);

} // namespace trivar
