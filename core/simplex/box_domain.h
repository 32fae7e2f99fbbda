// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_mesh.h"

namespace trivar {

// A box about the origin in that many boxes along each axis (1..100), each in 6 tetrahedra round
// its diagonal [Freudenthal, 1942]. Their faces fit. Vertices are numbered as boxes are, the last
// axis fastest.
SimplexMesh<3> box_cells(const glm::dvec3& size, const glm::ivec3& boxes);
// A rectangle in 2 triangles per box.
SimplexMesh<2> rectangle_cells(const glm::dvec2& size, const glm::ivec2& boxes);

} // namespace trivar
