// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_surface.h"

#include <string_view>

namespace trivar {

// The advice for the user where no size of tiles is large enough.
inline constexpr std::string_view too_many_faces_words =
    "simplify what they cover, each face of which carries one at least, or paint it with the "
    "brush Fill";

// Tells how rows of tiles run over the charts: by how many quarter turns the direction of its rows
// is turned from u. Rows go on from chart to chart along a tree of edges; over other edges they may
// turn. O(#charts).
std::vector<int> row_turns(const ChartNet& net);

// Counts the cells along u and v of each chart, the same on both sides of every edge: opposite
// edges of charts, and the two sides of an edge, form chords with one number each. That is the mean
// length of the middle lines along it by the size of a cell.
//   turns  row_turns() of the net
//   size   of a cell, along rows and across them, metres
//   even   rounds to even numbers
//   most   greatest number of cells; throws Rejected for more
// O(#charts log #charts).
std::vector<glm::ivec2> cell_counts(const ChartSurface& surface, std::span<const int> turns,
                                    const glm::dvec2& size, bool even, std::size_t most);

// Gives every edge the same number. Throws Rejected for more than `most` cells.
std::vector<glm::ivec2> cell_counts(const ChartNet& net, int per_edge, std::size_t most);

} // namespace trivar
