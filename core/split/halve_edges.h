// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/edge_numbers.h"

namespace trivar {

// The same surface in triangles; materials and groups of faces go along. O(#C).
Mesh triangulated(Mesh mesh);

// Splits edges of a mesh of triangles at their middles, for all triangles beside them:
//
//       /|\             /\               /\       a triangle
//      / | \           /__\             /__\      becomes two, three
//     /  |  \         / `. \           /\  /\     (along the shorter diagonal)
//    /___|___\       /____`.\         /__\/__\    or four
//
//   points  number of points of the mesh, which has `points`
//   marked  edges by points; edge k becomes point points + k
// Split triangles keep their place; the others of each are added at the end, and so are vertices.
// Returns the faces that are new or smaller. O(#F) in parallel; the same bits for any number of
// threads.
std::vector<std::uint32_t> halve_edges(Mesh& mesh, std::size_t points, const EdgeNumbers& marked);

} // namespace trivar
