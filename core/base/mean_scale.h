// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace trivar {

// Returns by how much a linear or affine map lengthens things: the cube root of the factor by which
// it changes volumes, at least 0. For a similarity that is its scale.
inline double mean_scale(const glm::dmat3& map)
{
    return std::cbrt(std::abs(glm::determinant(map)));
}
inline double mean_scale(const glm::dmat4& map)
{
    return mean_scale(glm::dmat3(map));
}

} // namespace trivar
