// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace trivar {

// Lengths of certificates, metres: JSON knows no infinity, so one that is not bounded is null.
inline nlohmann::ordered_json finite_or_null(double length)
{
    return std::isfinite(length) ? nlohmann::ordered_json(length) : nlohmann::ordered_json(nullptr);
}
// Throws nlohmann's exception where it is neither null nor a number.
inline double or_infinite(const nlohmann::ordered_json& length)
{
    return length.is_null() ? std::numeric_limits<double>::infinity() : length.get<double>();
}

} // namespace trivar
