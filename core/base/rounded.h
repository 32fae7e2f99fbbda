// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace trivar {

// The value rounded to whole multiples of a power of ten.
inline double rounded_to(double unit, double value)
{
    // Multiplying by a whole power of ten keeps 0.42 the nearest double to 0.42.
    return unit < 1 ? std::round(value / unit) / std::round(1 / unit)
                    : std::round(value / unit) * unit;
}

// The value rounded to `digits` significant digits, as a person would type it; 0 for a value that
// is not finite.
inline double rounded(double value, int digits)
{
    if (value == 0 || !std::isfinite(value)) return 0;
    return rounded_to(std::pow(10, std::floor(std::log10(std::abs(value))) - (digits - 1)), value);
}

// The same, but never below the value: for upper bounds.
inline double rounded_up(double value, int digits)
{
    const double near = rounded(value, digits);
    if (near >= value || near == 0) return near;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - (digits - 1));
    return rounded(near + unit, digits);
}

} // namespace trivar
