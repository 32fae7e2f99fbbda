// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Says whether two meshes have the same number of vertices and of corners, so that one can become
// the other vertex by vertex. Quads may be split along other diagonals.
bool can_become(const Mesh& from, const Mesh& to);

// Goes the share t of the way from every vertex of one mesh to that of the other: positions and
// colours; normals and tangents are of unit length again. Below 0 and above 1 it goes beyond, and
// colours stay between 0 and 1. All else is that of `from`. They must be able to become each
// other. O(#V).
Mesh morphed(const Mesh& from, const Mesh& to, double t);

} // namespace trivar
