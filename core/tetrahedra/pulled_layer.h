// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

// Finds the layer that a pull in a ball acts on (TetrahedraPull::layer): that of the last
// refinement that holds its middle, but the domain itself where a cut may be within reach, since
// the functions of refinements are continuous across cuts. Metres, in the domain at rest. O(number
// of places of all edits).
int pulled_layer(const TetrahedraShape& shape, const glm::dvec3& middle, double radius);

} // namespace trivar
