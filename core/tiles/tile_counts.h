// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// TileCounts are the numbers of tiles that a notice is given of, as they are left out or lowered.
struct TileCounts {
    int lowered = 0, folded = 0, at_borders = 0, overlapping = 0;
    TileCounts& operator+=(const TileCounts& other)
    {
        lowered += other.lowered;
        folded += other.folded;
        at_borders += other.at_borders;
        overlapping += other.overlapping;
        return *this;
    }
};

} // namespace trivar
