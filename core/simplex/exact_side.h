// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// Returns the side of a point at the line or plane through S points: 1 or -1, never 0, by exact
// arithmetic. Swapping two of the S points changes the sign.
//   numbers    of the S points; they decide the order of arithmetic, so all who share them agree
//   direction  a point on the line or plane counts as if it were moved a little along this
int exact_side(std::array<glm::dvec2, 2> line, std::array<int, 2> numbers, const glm::dvec2& point,
               const glm::dvec2& direction);
int exact_side(std::array<glm::dvec3, 3> plane, std::array<int, 3> numbers, const glm::dvec3& point,
               const glm::dvec3& direction);

} // namespace trivar
