// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"

#include <optional>

namespace trivar {

// Bounds the kernel on one side of an opening, over points of some heights.
struct SideBound {
    double reach;             // metres
    double nearest, farthest; // shares of the reach
    KernelBound kernel;       // between these
    double slope, curve;      // of the kernel, per metre and per square metre
};

// Gives the bound for points whose heights over the cut surface are between `least` and `most`
// metres, or beyond by `bend`. None: no such point is on that side and in reach. O(1).
inline std::optional<SideBound> side_bound(const Opening& opening, std::size_t side, double least,
                                           double most, double bend)
{
    if (side == 0 ? least - bend >= 0 : most + bend <= 0) return std::nullopt;
    const double r = opening.reach[side], per_metre = 1 / r;
    const double nearest = std::max(0.0, (side == 0 ? -most : least) - bend) * per_metre;
    if (nearest >= 1) return std::nullopt;
    const double farthest = ((side == 0 ? -least : most) + bend) * per_metre;
    const KernelBound kernel = kernel_bound(opening.kernel, nearest, farthest);
    return SideBound{r,
                     nearest,
                     farthest,
                     kernel,
                     kernel.first * per_metre,
                     kernel.second * (per_metre * per_metre)};
}

} // namespace trivar
