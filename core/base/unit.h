// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// The vector with the length 1; 0 where it has no length.
inline glm::dvec3 unit_or_zero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

} // namespace trivar
