// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"
#include "core/spline/surface.h"

namespace trivar {

// The surface w = `level` of a volume, in the world, over the volume's own u and v axes; a closed
// axis stays closed. O(#control points).
Surface<glm::dvec3> level_surface(const Lattice& volume, double level);

} // namespace trivar
