// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/cell_polynomials.h"

namespace trivar {

// What becomes of a chunk, in the order of its sorted vertices; the room of SortedVertices::slack
// more is scribbled on. Null: not wanted. Tangents are wanted only with normals.
struct ChunkResult {
    std::size_t begin; // of the chunk, in the order
    glm::vec3 *positions, *normals, *tangents;
};

// Deforms one chunk. A normal or tangent that cannot be told is (0, 0, 0); returns whether there
// was one.
//
// Arithmetic is a lane's own: what comes out for a vertex depends on its position and the lattice
// alone, not on the other vertices, the order or the width of a register. Sums of products are
// fused on every processor that can (AVX2 and newer), and then have the same bits on all of them.
bool deform_chunk(const SortedVertices& vertices, std::size_t chunk,
                  const CellPolynomials& polynomials, const ChunkResult& out);

} // namespace trivar
