// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/unit.h"

#include <glm/glm.hpp>

namespace trivar {

// Projects t onto the plane of a unit normal and makes it unit; zero where t has no part in it.
inline glm::dvec3 in_tangent_plane(const glm::dvec3& t, const glm::dvec3& normal)
{
    return unit_or_zero(t - glm::dot(t, normal) * normal);
}

// Rotates t as the smallest rotation that takes the unit vector a to the unit vector b.
inline glm::dvec3 turned_from_to(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& t)
{
    const glm::dvec3 w = glm::cross(a, b);
    const double cosine = glm::dot(a, b);
    if (cosine < -0.999999) return -t; // any half turn is as small
    return t + glm::cross(w, t) + glm::cross(w, glm::cross(w, t)) / (1 + cosine);
}

} // namespace trivar
