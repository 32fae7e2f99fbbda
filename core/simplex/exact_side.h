// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// The side of a point at the line or plane through S points with numbers: 1 or -1, never 0, by
// exact arithmetic. A point on it belongs to the side to which `direction` leads, as though it were
// moved a little along that. Swapping two of the S points changes the sign. The numbers decide in
// which order these enter the arithmetic, so that all who share them agree.
int exact_side(std::array<glm::dvec2, 2> line, std::array<int, 2> numbers, const glm::dvec2& point,
               const glm::dvec2& direction);
int exact_side(std::array<glm::dvec3, 3> plane, std::array<int, 3> numbers, const glm::dvec3& point,
               const glm::dvec3& direction);

} // namespace trivar
