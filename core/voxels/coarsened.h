// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

namespace trivar {

// A grid with one sample for `times` of another one along each axis: their mean, rounded where
// samples are whole numbers, in the middle of their places. At its end an axis that is no multiple
// leaves out what is left over; an axis of less than 2 * times samples keeps 2. Takes so much less
// memory: what is too large to work on can be looked at first. O(#samples), in parallel.
VoxelGrid coarsened(const VoxelGrid& grid, const glm::ivec3& times);

} // namespace trivar
