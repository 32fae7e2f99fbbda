// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_mesh.h"

#include <functional>

namespace trivar {

// A CellParting says how cells fill a box so that none of them lies on both sides of a boundary.
struct CellParting {
    Box box;
    std::function<bool(const glm::dvec3&)> inside; // of the boundary; asked for places in the box
    double edge = 0;                               // length of edges of cells
    double boundary_edge = 0; // and of the faces on the boundary; no more than `edge`
    std::size_t cell_limit = usual_cell_limit;
};

struct PartedCells {
    SimplexMesh<3> mesh;
    std::vector<bool> inside; // by cell
};

// Cells that fill the box, to rounding, with faces between those inside and outside that have their
// vertices on the boundary, to 1e-5 of the box, and are off it by at most a tenth of an edge; cells
// have edges along the lines where the boundary meets the box (box_lines.h). A body smaller than a
// cell may be missed. The mesher is that of cage_cells(), and takes 0.1 ms per cell; but CGAL's
// perturbation of slivers is left out, as it takes them in the order of their addresses, so that no
// two runs of a program are the same. Throws Rejected for lengths that are none, where all of the
// box lies on one side, and where there would be more cells than the limit. One thread, so always
// the same bits.
PartedCells parted_cells(const CellParting& parting);

// The faces between cells inside and outside, as cuts of a spline of a degree.
std::vector<Crease<3>> cuts_between(const PartedCells& cells, int degree);

} // namespace trivar
