// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaper.h"

namespace trivar {

// A volume that is a box about the origin, at rest, in the form that place() gives for a stroke. u,
// v and w run along X, Y and Z. `size` is in metres, above 0; the grid must have enough control
// points for the orders. A press moves control points up or down toward the middle of the box.
Placement place_box(const glm::dvec3& size, const glm::ivec3& grid, const glm::ivec3& orders);

// The volume after an affine map. Directions, radii and reports stay those of the given volume; so
// does what is proven of its folds, for the map folds nothing.
ShapedVolume mapped(const ShapedVolume& volume, const glm::dmat4& to_world);

} // namespace trivar
