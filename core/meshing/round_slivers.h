// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_mesh.h"

#include <cstdint>

namespace trivar {

// Moves vertices along the axes that they may move along (bits 1, 2, 4: x, y, z) so that cells with
// a dihedral angle below the least one, in radians, become rounder, as far as that goes: no cell's
// angle becomes less than the least of those round the vertex was. The same each time, which
// CGAL's own ways to do that are not: they gave other cells in a tenth of all runs. O(number of
// slivers).
void round_slivers(SimplexMesh<3>& mesh, const std::vector<std::uint8_t>& axes, double least_angle);

} // namespace trivar
