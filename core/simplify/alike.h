// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// How the vertices of one point differ. Everything here compares vertices of the same mesh.

// By vertex, the first of its point that has all the same values.
std::vector<std::uint32_t> first_equal_vertices(const Mesh& mesh);

// Whether the normals are at most 30 degrees apart: one bent surface, not two that meet.
bool smooth(const Mesh& mesh, std::uint32_t v, std::uint32_t w);

// Whether a surface may go on from one vertex to the other without a line between: smooth, with
// the same texture coordinates (to 1e-5), colours, influences and morph targets.
bool alike(const Mesh& mesh, std::uint32_t v, std::uint32_t w);

} // namespace trivar
