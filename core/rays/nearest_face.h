// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Finds where the line origin + t along, t > 0, meets a face of a mesh first, from either side, and
// returns t, or `nearest` where none is nearer. The line is in the space into which `to_world`
// takes the mesh; polygons count as fans. O(#C): for a line or two, for which no RayScene is worth
// building. [Moeller, Trumbore 1997]
double nearest_face(const Mesh& mesh, const glm::dmat4& to_world, const glm::dvec3& origin,
                    const glm::dvec3& along, double nearest);

} // namespace trivar
