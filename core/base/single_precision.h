// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// Rounds to single precision, for a caller that goes on in double precision with the rounded
// numbers. It is compiled apart from its callers: g++ 12.2 leaves the rounding out where it
// vectorises the conversion there and back together.
glm::vec3 in_single_precision(const glm::dvec3& v);

} // namespace trivar
