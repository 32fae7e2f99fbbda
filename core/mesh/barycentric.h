// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// The barycentric coordinates of p, a point of the triangle's plane: shares of the three corners,
// with sum 1; a share is negative outside. (1, 0, 0) where the triangle has no area. The foot of p
// where it is off the plane.
inline glm::dvec3 barycentric(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t)
{
    const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac),
                 pb = glm::dot(ap, ab), pc = glm::dot(ap, ac);
    const double area = bb * cc - bc * bc;
    if (!(area > 0)) return {1, 0, 0};
    const double v = (cc * pb - bc * pc) / area, w = (bb * pc - bc * pb) / area;
    return {1 - v - w, v, w};
}

} // namespace trivar
