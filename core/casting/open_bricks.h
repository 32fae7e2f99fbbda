// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/transfer_table.h"
#include "core/level/voxel_field.h"

#include <cstdint>

namespace trivar {

struct EmptyBricks;

// OpenBricks hold the share of the light from all around that reaches the middle of each brick of a
// field's hulls; 255: all of it. It darkens hollows and inner parts.
struct OpenBricks {
    glm::ivec3 count{0};
    std::vector<std::uint8_t> share; // x fastest
};

// Goes from each brick in 14 directions, up to 12 bricks far, through the mean density of bricks.
// Voxels count as cubes. O(#bricks), 1 us each that shows something or is next to one that does;
// the same for any number of threads.
OpenBricks open_bricks(const ScalarField<float>& field, const EmptyBricks& empty,
                       const TransferTable& transfer, const glm::dvec2& share_of_sample);

} // namespace trivar
