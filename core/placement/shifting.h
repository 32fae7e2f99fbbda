// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

namespace trivar {

// Where the control points of a shift go, each once. Throws Rejected where it was meant for a
// volume of other numbers, or names points that there are not.
std::vector<PointMove> moves_of(const Lattice& volume, const PointShift& shift);

// What a shift turns and scales about: the middle of the points that it has full hold of, all on
// the side of the first one where it mirrors. The points must be there, one at least.
glm::dvec3 middle_of(const Lattice& volume, const PointShift& shift);

// The point on the other side of the middle along each axis of the mask (1 along, 2 across, 4 up).
glm::ivec3 mirrored_point(glm::ivec3 point, const glm::ivec3& count, int axes);
// The axes of a shift that mirror, as such a mask.
int mirror_axes(const PointShift& shift);
// Along which of those axes a point is on another side of the middle than the first point of the
// shift; where that lies in the middle itself and there are weights, than the far side.
int away_from_first(const glm::ivec3& point, const glm::ivec3& count, const PointShift& shift);

} // namespace trivar
