// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

namespace trivar::testing {

// Twice the area of a region in square units; that of a hole counts as negative.
inline std::int64_t doubled_area(const Region& region)
{
    std::int64_t sum = 0;
    for (const Loop& loop : region)
        for (std::size_t i = 0; i < loop.size(); ++i)
            sum += turn({0, 0}, loop[i], loop[(i + 1) % loop.size()]);
    return sum;
}

} // namespace trivar::testing
