// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// The values of all DMS basis functions of a domain at x, by cell and multi-index, by the recursion
// of Micchelli in rational arithmetic: slow, and the truth. A point on the border of a simplex
// belongs to the side to which `direction` leads.
std::vector<double> exact_values(const SimplexDomain<3>& domain, const glm::dvec3& x,
                                 const glm::dvec3& direction);

} // namespace trivar
