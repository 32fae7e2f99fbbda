// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_mesh.h"

namespace trivar {

// Some cells of a mesh (a flag for each), and as many more as are needed for a border that is a
// surface: where only two parts meet in a vertex or an edge, all cells around that are added.
// O(n log n) per round, few rounds.
std::vector<bool> with_manifold_border(const SimplexMesh<3>& mesh, std::vector<bool> chosen);

// The faces of the border of some cells, each with its vertices ascending.
std::vector<std::array<int, 3>> border_faces(const SimplexMesh<3>& mesh,
                                             const std::vector<bool>& chosen);

} // namespace trivar
