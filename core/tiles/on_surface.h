// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace trivar {

// Projects v onto the plane of a unit normal and makes it unit; some direction of the plane where v
// has no part in it.
inline glm::dvec3 direction_on(const glm::dvec3& v, const glm::dvec3& n)
{
    const glm::dvec3 flat = v - glm::dot(v, n) * n;
    const double length = glm::length(flat);
    if (length > 1e-9 * glm::length(v)) return flat / length;
    const glm::dvec3 other = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(other - glm::dot(other, n) * n);
}

// Whether two places with these unit normals are on the same side of a thin sheet.
inline bool same_side(const glm::dvec3& n, const glm::dvec3& m)
{
    return glm::dot(n, m) > -0.2;
}

// Returns the share of a brush at a distance from its middle: 1 there, 0 and flat at its rim.
inline double brush_share(double distance, double radius)
{
    const double r = std::min(1.0, distance / radius), s = 1 - r * r;
    return s * s;
}

// Turns a direction of the plane of a unit normal about that, radians.
inline glm::dvec3 turned_about(const glm::dvec3& x, const glm::dvec3& n, double angle)
{
    return std::cos(angle) * x + std::sin(angle) * glm::cross(n, x);
}

// The angle from one direction of the plane of a unit normal to another, radians.
inline double angle_about(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& n)
{
    return std::atan2(glm::dot(glm::cross(from, to), n), glm::dot(from, to));
}

} // namespace trivar
