// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// T has no two directions where a side of a patch has no length, as over a triangle. The normal
// there is its limit from inside: it is taken nearer to the middle of the tile by this share.
// gpu/shaders/tile.glsl does the same.
inline constexpr float pinch_inside = 1.0f / 64;
// A direction that is shorter than the other by this factor is none.
inline constexpr float pinched = 1e-4f;
inline bool is_pinched(const glm::dvec3& x, const glm::dvec3& y)
{
    const double a = glm::dot(x, x), b = glm::dot(y, y);
    return glm::min(a, b) < double(pinched) * double(pinched) * glm::max(a, b);
}

} // namespace trivar
