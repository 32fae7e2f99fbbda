// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/simplex/simplex_basis.h"

namespace trivar {

// The greatest value of the functions of a control point at the samples of a grid of that many
// steps per axis over their knots.
double greatest_value(const SimplexBasis<3>& basis, int point, int steps = 24);

// Returns the surface on which the functions of a control point have a value, as triangles with
// normals toward lesser values: closed unless a cut goes through. Empty if the value is nowhere
// reached.
//   point  number of the control point
//   steps  per axis of a grid whose tetrahedra are marched through [Doi, Koide, 1991]; Newton's
//          method then puts the vertices on the surface to 1e-9 where it is smooth
// Evaluates steps^3 points: 1 s for 64 and degree 2.
Mesh function_surface(const SimplexBasis<3>& basis, int point, double value, int steps = 64);

} // namespace trivar
