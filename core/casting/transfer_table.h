// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/transfer.h"

namespace trivar {

// A TransferTable holds the integrals of a transfer function over the values of some data, so that
// the integral between two values along a ray is a difference of two entries, however thin it is
// [Engel, Kraus, Ertl 2001]. Values are given as shares, 0..1, of the range of the data.
struct TransferTable {
    static constexpr int cells = 1024;
    double least = 0, greatest = 1; // of the data
    // The integral from the share 0 to each end of a cell: of the density of extinction per voxel,
    // in w, and of the linear colour times that density.
    std::vector<glm::vec4> before;

    // The integral up to a share, 0..1.
    glm::vec4 before_share(float share) const
    {
        const float at = share * cells;
        const int i = glm::min(static_cast<int>(at), cells - 1);
        const glm::vec4* const entry = &before[static_cast<std::size_t>(i)];
        return entry[0] + (at - static_cast<float>(i)) * (entry[1] - entry[0]);
    }
    // Whether nothing is seen of values from `low` to `high`, or next to them.
    bool empty(double low, double high) const;
    std::size_t bytes() const { return before.size() * sizeof(glm::vec4); }
};

// 0.1 ms.
TransferTable transfer_table(std::span<const TransferPoint> points, double least, double greatest);

} // namespace trivar
