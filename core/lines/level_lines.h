// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/voxel_field.h"
#include "core/lines/shape_lines.h"

namespace trivar {

// A LevelLines is what further lines of a level are found by. It belongs to no view: the surface
// with its bends, and those lines that are the same in all views.
struct LevelLines {
    // Transforms voxels to the space of the surface, which has the angles of the data and whose
    // unit is the mean side of a voxel.
    glm::dmat4 from_voxels{1};
    SurfaceShape shape;
    std::vector<KindLines> fixed; // in voxels, on the level
    std::size_t bytes() const;
};

// The function of volume data after a Gauss bell of `smoothing` mean voxel sides, in the angles of
// its own space: second derivatives of what was measured show the sampling more than the body. 0:
// none. 30 ns per sample.
ScalarField<float> smooth_field(const VoxelField& field, float smoothing);

// Finds the further lines of a level. `smooth` gives the bends; to_space, affine, has the angles
// that count. 0.4 us per vertex.
LevelLines level_lines(const VoxelField& field, const ScalarField<float>& smooth,
                       const LevelMesh& level, LevelSide side, const glm::dmat4& to_space,
                       const MoreLines& wanted);

// Finds all wanted lines of a level that a view from voxels shows: the fixed ones as they are, and
// suggestive contours, see suggestive_lines().
std::vector<KindLines> lines_seen(const LevelLines& lines, const MoreLines& wanted,
                                  const ViewPoint& view, const ScalarField<float>& field,
                                  float level);

} // namespace trivar
