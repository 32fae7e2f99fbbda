// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// Eases a share, 0..1, into and out of its ends: 3 t^2 - 2 t^3, which has no slope at both.
inline double smooth_step(double t)
{
    return t * t * (3 - 2 * t);
}

} // namespace trivar
