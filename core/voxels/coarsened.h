// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

namespace trivar {

// Makes a grid with one sample for `times` of another one along each axis: their mean, rounded if
// samples are whole numbers, in the middle of their places. An axis that is no multiple loses the
// samples left over at its end; an axis of less than 2 * times samples keeps 2. Data too large to
// work on can so be viewed first. O(#samples), in parallel.
VoxelGrid coarsened(const VoxelGrid& grid, const glm::ivec3& times);

// The numbers of samples along each axis that one is made of, for a grid of that size.
glm::ivec3 coarsening_steps(const glm::ivec3& size, const glm::ivec3& times);
// Samples of a grid of that size, one for a step of them; as coarsened() makes them.
VoxelGrid::Samples coarsened_samples(const VoxelGrid::Samples& samples, const glm::ivec3& size,
                                     const glm::ivec3& step);
// Returns the transform of the coarsened grid, given that of the full one.
glm::dmat4 coarsened_place(const glm::dmat4& to_metres, const glm::ivec3& step);

} // namespace trivar
