// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A vertex on the edge from one vertex to another, at t from 0 to 1.
struct BornVertex {
    std::uint32_t a, b;
    float t;
    std::uint32_t point; // for Mesh::points, where the mesh has them
};

// The mesh with further vertices behind its own, in their order: positions are rounded once,
// normals and tangents unit again. Faces stay as they are. a and b are among the mesh's own.
void add_vertices(Mesh& mesh, const std::vector<BornVertex>& born);

} // namespace trivar
