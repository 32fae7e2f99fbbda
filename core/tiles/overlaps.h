// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/layout.h"

#include <span>

namespace trivar {

// A TileOutline is the rectangle that a tile covers in the plane of its normal, on the base at
// rest: along its x axis and across, about its middle.
struct TileOutline {
    glm::dvec3 p{0}, x{1, 0, 0}, n{0, 0, 1}; // metres on the model; unit
    glm::dvec2 half{0};                      // of its length and width, metres; 0: it is not there
};

// The depth of the overlap of two outlines, metres: how far one must go at least so that they do
// not overlap; 0 where they do not, or lie on different sides of a sheet.
double overlap_depth(const TileOutline& a, const TileOutline& b);

// Two tiles overlap where the depth is more than this share of the lesser of their longer sides.
inline constexpr double overlap_share = 0.1;

// Tells of each tile whether it overlaps another one. In parallel; about a microsecond per tile.
std::vector<char> overlapping(std::span<const TileOutline> tiles);

// Tells of each tile whether it overlaps an earlier one that stays: without all of these no tile
// overlaps another. About 2 microseconds per tile.
std::vector<char> overlapping_earlier(std::span<const TileOutline> tiles);

} // namespace trivar
