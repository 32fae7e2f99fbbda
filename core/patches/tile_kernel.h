// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/patches/placed_tile.h"

#include <vector>

namespace trivar {

// TileVertices are the vertices of a tile in its unit cell, arranged for registers.
struct TileVertices {
    static constexpr std::size_t slack = 16; // of every array, behind the last vertex
    explicit TileVertices(const Mesh& unit);
    std::array<std::vector<float>, 3> position, normal; // normals are empty where there are none
    std::array<std::vector<float>, 4> tangent;          // the same; the fourth is the handedness
    std::size_t count = 0;
};

// BentVertices are where the vertices of one bent tile are written to, #vertices each. A null
// pointer stands for an attribute that is not asked for, or that the tile does not have.
struct BentVertices {
    glm::vec3* positions;
    glm::vec3* normals;  // unit; (0, 0, 1) where the tile is flat
    glm::vec4* tangents; // unit; the handedness stays
};

// Bends the vertices of one tile.
//   offset  positions are offset + T - origin, rounded once at the scale of the tile and once more
//           at that of the offset
//   out     receives #vertices of each wanted attribute; normals are exact, by the cofactors of the
//           derivatives of T
// Each vertex is computed by itself, and sums of products are fused where the processor can, as in
// core/ffd/kernel.h. About 300 million vertices per second on one core with AVX-512.
void bend_vertices(const TileVertices& vertices, const TilePowers& tile, const glm::vec3& offset,
                   const BentVertices& out);

} // namespace trivar
