// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace trivar {

// Eases a share into and out of its ends: 3 t^2 - 2 t^3, which has no slope at 0 and 1; 0 below
// and 1 above, as GLSL's smoothstep().
inline double smooth_step(double share)
{
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace trivar
