// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/depth_jump.h"

#include <algorithm>
#include <cmath>

namespace trivar {

const DepthJump& deepest(const std::vector<DepthJump>& jumps)
{
    return *std::ranges::max_element(jumps, {},
                                     [](const DepthJump& each) { return std::abs(each.depth); });
}

} // namespace trivar
