// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A BornVertex is a new vertex on the edge from vertex a to vertex b, at t from 0 to 1.
struct BornVertex {
    std::uint32_t a, b;
    float t;
    std::uint32_t point; // its number in Mesh::points, where the mesh has them
};

// Appends new vertices to the mesh, in their order. Positions are rounded once; normals and
// tangents are made unit again. Faces stay as they are. a and b must be among the mesh's own
// vertices.
void add_vertices(Mesh& mesh, const std::vector<BornVertex>& born);

} // namespace trivar
