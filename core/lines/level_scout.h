// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/voxel_grid.h"

#include <vector>

namespace trivar {

// A LevelScout tells how much line each level of volume data would give: what one looks at to find
// a level worth drawing. Noise has much line, and a body has about as much on levels nearby.
struct LevelScout {
    std::vector<double> values;  // ascending, evenly spread over the data's
    std::vector<double> lengths; // of all silhouettes, voxels of the coarse grid; mean of 3 views
    // Numbers of the values about which the length changes least, relative to itself: where to snap
    // to. A peak is none. Ascending.
    std::vector<std::size_t> plateaus;
};

// Scouts that many levels, at least 3, on the data averaged to at most `most` samples an axis. 64
// levels take about a second; the same for any number of threads. Throws Cancelled.
LevelScout scout_levels(const VoxelGrid& grid, int levels = 64, int most = 64,
                        const Progress& progress = {});

} // namespace trivar
