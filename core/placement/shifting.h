// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

namespace trivar {

// The moves of a shift, one per control point. Throws Rejected where the shift was made for a
// volume with other numbers of control points, or names points that do not exist.
std::vector<PointMove> moves_of(const Lattice& volume, const PointShift& shift);

// The point about which a shift turns and scales: the middle of the points with weight 1, or, where
// it mirrors, of those on the side of the first one. The points must exist, at least one.
glm::dvec3 middle_of(const Lattice& volume, const PointShift& shift);

// The point on the other side of the middle along each axis of the mask (1 along, 2 across, 4 up).
glm::ivec3 mirrored_point(glm::ivec3 point, const glm::ivec3& count, int axes);
// The mask of the axes along which a shift mirrors.
int mirror_axes(const PointShift& shift);
// The axes among those along which a point is on the other side of the middle than the first point
// of the shift. Where that one lies in the middle itself and there are weights, the far side counts
// as the other side.
int away_from_first(const glm::ivec3& point, const glm::ivec3& count, const PointShift& shift);

} // namespace trivar
