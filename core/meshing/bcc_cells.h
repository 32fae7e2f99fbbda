// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/simplex/simplex_mesh.h"

namespace trivar {

// Equal tetrahedra with edges of lengths 1 and 0.866 times `edge` and angles of 60 and 90 degrees
// that hold a box: the Delaunay cells of a body-centred cubic lattice, which are the best shaped
// of those that fill space with one shape. Its border is ragged. 12 cells per edge^3; the caller
// bounds their number.
SimplexMesh<3> bcc_cells(const Box& box, double edge);

// About how many cells that would be.
double bcc_cell_count(const Box& box, double edge);

} // namespace trivar
