// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/cell_polynomials.h"

namespace trivar {

// A ChunkResult takes the results for a chunk, in the order of its sorted vertices.
// SortedVertices::slack elements behind it are overwritten. Null: not wanted. Tangents are wanted
// only together with normals.
struct ChunkResult {
    std::size_t begin; // of the chunk, in the order
    glm::vec3 *positions, *normals, *tangents;
};

// Deforms one chunk of the mesh.
//   chunk        its number in `vertices`
//   polynomials  of the occupied cells of `vertices`
//   out          receives the results; a normal or tangent that cannot be determined is (0, 0, 0)
// Returns whether there was such a normal or tangent. Each vertex is computed by itself: its result
// depends on its position and the lattice, not on other vertices, their order or the width of a
// register. Sums of products are fused on every processor that can (AVX2 and newer), and then have
// the same bits on all of these.
bool deform_chunk(const SortedVertices& vertices, std::size_t chunk,
                  const CellPolynomials& polynomials, const ChunkResult& out);

} // namespace trivar
