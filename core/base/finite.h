// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace trivar {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

// Whether no component of a glm vector is infinite or not a number.
template <class Vector> bool finite(const Vector& v)
{
    for (int i = 0; i < Vector::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

} // namespace trivar
