// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/empty_bricks.h"
#include "core/casting/open_bricks.h"

namespace trivar {

// A Casting is volume data with a transfer function, ready for rays.
struct Casting {
    Ref<VoxelField> field;
    TransferTable transfer;
    EmptyBricks empty;
    OpenBricks open;
    glm::dvec2 share_of_sample{1, 0}; // the share of the range that a sample a is: x a + y
};

// The range is that of the data's values.
Casting casting_of(const Ref<VoxelField>& field, std::span<const TransferPoint> points,
                   double least, double greatest);

} // namespace trivar
