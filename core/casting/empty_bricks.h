// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/transfer_table.h"
#include "core/level/voxel_field.h"

#include <cstdint>

namespace trivar {

// EmptyBricks say of each brick of a field's hulls (FieldHulls) how far empty space reaches round
// it: all bricks of the cube of 2 n - 1 bricks round one with the number n show nothing. 0: the
// brick may show something. Beyond the grid all is empty. 1/64 byte per voxel.
struct EmptyBricks {
    glm::ivec3 count{0};
    std::vector<std::uint8_t> reach; // x fastest; at most 255

    int of(glm::ivec3 brick) const // not below 0; beyond the grid as at its border
    {
        brick = glm::min(brick, count - 1);
        return reach[static_cast<std::size_t>(brick.x + count.x * (brick.y + count.y * brick.z))];
    }
};

// `share_of_sample`: maps a sample a to x a + y, its share of the range of the table. O(#bricks),
// 30 ns each. Source: the distances of a chessboard in two passes [Rosenfeld, Pfaltz 1966].
EmptyBricks empty_bricks(const FieldHulls& hulls, const TransferTable& transfer,
                         const glm::dvec2& share_of_sample);

} // namespace trivar
