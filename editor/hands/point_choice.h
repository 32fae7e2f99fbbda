// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

#include <vector>

namespace trivar {

// These functions choose control points of a volume by their numbers along its three axes. `count`
// is the number of points along each axis.
using Points = std::vector<glm::ivec3>;

glm::ivec3 point_count(const Lattice& volume);
// The number of a point among all, from 0 up, the last axis fastest; and back.
int number_of(const glm::ivec3& point, const glm::ivec3& count);
glm::ivec3 point_of(int number, const glm::ivec3& count);
// Returns the points that exist with that count.
Points within(Points points, const glm::ivec3& count);
Points all_points(const glm::ivec3& count);
Points row_of(const glm::ivec3& point, int axis, const glm::ivec3& count);   // along the axis
Points plane_of(const glm::ivec3& point, int axis, const glm::ivec3& count); // across the axis
Points with_next(const Points& chosen, const glm::ivec3& count); // one step along each axis

} // namespace trivar
