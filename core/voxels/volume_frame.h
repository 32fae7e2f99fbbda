// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// A VolumeFrame says where a grid lies, in a file's units and axes: the place of sample (0, 0, 0),
// and per column the step from a sample to the next along that axis of the grid.
struct VolumeFrame {
    glm::dvec3 origin{0};
    glm::dmat3 steps{1};
};

// The frame of a grid that stands along the axes of space.
inline VolumeFrame upright_frame(const glm::dvec3& spacing, const glm::dvec3& origin = {0, 0, 0})
{
    return {origin, {{spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}}};
}

// The same frame where x and y of the file go the other way: RAS, as NIfTI has it, to LPS. `signs`
// has 1 or -1 for each axis of space.
inline VolumeFrame turned_frame(VolumeFrame frame, const glm::dvec3& signs)
{
    frame.origin *= signs;
    for (int k = 0; k < 3; ++k) frame.steps[k] *= signs;
    return frame;
}

// Whether all numbers are finite and of sizes that can be worked with, no step is zero and the
// three do not lie in a plane.
bool spans_space(const VolumeFrame& frame);

// Voxel space to metres, for VoxelGrid::to_metres.
glm::dmat4 to_metres_of(const VolumeFrame& frame, double metres_per_unit);

} // namespace trivar
