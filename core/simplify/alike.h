// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// These functions say how the vertices of one point differ. Both vertices must be of the same mesh.

// Returns, for each vertex, the first vertex of its point that has all the same values.
std::vector<std::uint32_t> first_equal_vertices(const Mesh& mesh);

// Whether the normals are at most 30 degrees apart: one bent surface, not two surfaces that meet.
bool smooth(const Mesh& mesh, std::uint32_t v, std::uint32_t w);

// Whether a surface may continue from one vertex to the other without a line between them: smooth,
// with the same texture coordinates (to 1e-5), colours, influences and morph targets.
bool alike(const Mesh& mesh, std::uint32_t v, std::uint32_t w);

} // namespace trivar
