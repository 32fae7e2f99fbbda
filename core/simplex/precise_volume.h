// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// The volume of one simplex over that of another one, with twice the digits of double in between:
// right to rounding also where both are so flat that their determinants lose ten digits [1]. About
// 100 ns.
//   [1] Dekker, A floating-point technique for extending the available precision, 1971
double volume_ratio(const std::array<glm::dvec2, 3>& simplex,
                    const std::array<glm::dvec2, 3>& whole);
double volume_ratio(const std::array<glm::dvec3, 4>& simplex,
                    const std::array<glm::dvec3, 4>& whole);

} // namespace trivar
