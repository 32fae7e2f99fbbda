// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"
#include "core/tiles/chart.h"
#include "core/tiles/limit_base.h"

#include <optional>
#include <span>

namespace trivar {

// A StationChart places the four nodes across a strand at one of its stations, on straight ways to
// both sides. Cells that meet at a station share its nodes:
//
//      y = 1    o----o-----------o----o      one cell: 4 x 4 nodes at 0, 1/4, 3/4 and 1
//        3/4    o    o           o    o      along x, the strand, and across it
//        1/4    o    o           o    o
//          0    o----o-----------o----o      its end stations are those of the cells
//            station 0   1           2    3  before and behind
struct StationChart {
    std::array<SurfacePlace, 4> flat;   // at patch_nodes, on the triangles of the base
    std::array<glm::dvec3, 4> beyond{}; // what a border cut off, in the space of the model
    std::array<SurfacePoint, 4> smooth; // on its limit surface at rest, where there is one
    std::size_t piece = 0;
    double cut = 0; // the longest way that was cut off, as a share of the width
};
// `width` is that of the cells there, metres on the model; `limit` may be null. About 4
// microseconds on triangles and 15 on a limit surface.
StationChart station_chart(const TileBase& base, const LimitBase* limit,
                           const StrandStation& station, double width);

// StrandNodes are the nodes of a station where the base is now.
using StrandNodes = std::array<SurfacePoint, 4>;

// Makes the patch of a cell. Two cells that meet have the same points at their common end, to the
// last bit, and go on in the same direction: from the node before the end to the node behind it.
//   nodes     #stations, where the base is now
//   heights   #stations: metres in the world of one unit of z
//   mirrored  the base is seen in a mirror, and the sides of the strand change places
TilePatch strand_patch(const StrandLayout& layout, std::size_t cell,
                       std::span<const StrandNodes> nodes, std::span<const double> heights,
                       bool mirrored);

// The part of a patch between two values of x, as a patch of its own. An end that stays an end
// keeps its bits.
TilePatch part_along_x(const TilePatch& patch, double from, double to);

// The share of a cell that has grown when a layer has grown so far, as a piece of its x; empty: it
// is not there yet. Strands grow evenly along their path.
std::optional<glm::dvec2> grown(const StrandCell& cell, double growth, double duration_s);

} // namespace trivar
