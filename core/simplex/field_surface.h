// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/simplex/simplex_field.h"

namespace trivar {

// Returns the closed surface of the body f >= level, as triangles. Where f is continuous it is
// marched through the pieces of each cell [Doi, Koide, 1991]; its vertices are on f to 1e-9 of f's
// range, on the edges of pieces, and have the direction of its gradient as their normals. The
// border of the domain, and the cut faces at which only one side is in the body, belong to the
// surface. Cut faces are curved, with normals that go smoothly from one face to the next
// (CurvedTears), and f is marched up to the flat faces under them.
//   inside  one flag per cell: the cuts lie between the two parts; empty: there are none
//   steps   each cell has steps^3 pieces
// Points are those of Mesh::points: each edge has as many triangles on one side as on the other.
// Cost: about 10 us per point of the pieces, and 50 us per vertex. The same bits for any number of
// threads.
Mesh field_surface(const SimplexField& field, const std::vector<bool>& inside, double level,
                   int steps);

} // namespace trivar
