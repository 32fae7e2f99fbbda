// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/edge_numbers.h"

namespace trivar {

// The same surface in triangles; materials and groups of faces go along.
Mesh triangulated(const Mesh& mesh);

// Splits edges of a mesh of triangles at their middles, for all triangles beside them: a triangle
// becomes two, three or four. `marked` holds edges by points, and the mesh has points. Triangles
// that are split keep their place, others of the same one are added at the end. Returns the faces
// that are new or smaller. O(#V + #F).
std::vector<std::uint32_t> halve_edges(Mesh& mesh, const EdgeNumbers& marked);

} // namespace trivar
