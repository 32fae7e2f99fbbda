// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Moves the vertices of `out`, which is transformed(mesh, m) for a matrix m that mirrors exactly
// where `matrix` does, to where transformed(mesh, matrix) has them. Nothing else is touched. `out`
// may be the mesh. O(#V) in parallel.
void transform_again(Mesh& out, const Mesh& mesh, const glm::dmat4& matrix);

} // namespace trivar
