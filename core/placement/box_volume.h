// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaper.h"

namespace trivar {

// Makes a volume that is a box about the origin, at rest, in the form that place() gives for a
// stroke. u, v and w run along X, Y and Z. A press moves control points up or down toward the
// middle.
//   size    metres, above 0
//   grid    control points along X, Y and Z, enough for the orders
//   orders  2..6 each
Placement place_box(const glm::dvec3& size, const glm::ivec3& grid, const glm::ivec3& orders);

// The volume after an affine map. Directions, radii and reports stay those of the given volume; so
// does what is proven of its folds, for the map folds nothing.
ShapedVolume mapped(const ShapedVolume& volume, const glm::dmat4& to_world);

} // namespace trivar
