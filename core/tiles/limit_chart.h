// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"
#include "core/tiles/layout.h"
#include "core/tiles/limit_base.h"

namespace trivar {

// A LimitChart is where the nodes of a tile's patch are on a limit surface at rest: the exponential
// map of its middle, by geodesics.
struct LimitChart {
    std::array<SurfacePoint, 16> nodes; // 4 j + i at (patch_nodes[i], patch_nodes[j])
    std::size_t piece = 0;              // of the LimitBase
    // The longest way that a border cut off, as a share of the tile's size; beyond it nodes go on
    // straight. Infinite where there is no chart: the tile is larger than the base, or ways from
    // its middle meet again within it.
    double cut = 0;
};

// Lays out the nodes of a tile's patch. `turn_deg` and `scale` come from the layer's look. 25 to 55
// us for a tile that is small against the features of the surface, ten times as much for one of
// their size.
LimitChart limit_chart_of(const LimitBase& base, const Tile& tile, double turn_deg, double scale);

} // namespace trivar
