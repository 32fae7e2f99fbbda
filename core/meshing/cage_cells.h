// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/grading.h"

#include <span>

namespace trivar {

struct CageCells {
    SimplexMesh<3> mesh;
    double edge = 0;     // of these cells, as it was asked of the mesher in the end
    bool capped = false; // edges are longer than asked, because of the limit of cells
    bool exact = false;  // the border is the cage; otherwise near it, to about 2 % of an edge where
                         // it is smooth, and without its corners
};

// Cells that fill the inside of a closed surface. Exact for a cage as an artist draws it: its
// corners, which are the ends of edges that bend by more than a degree, are vertices of the cells,
// those edges are chains of edges of cells, and flat faces are unions of faces of cells, to
// rounding. Where the mesher cannot keep all of these, for edges much shorter than cells meet, it
// keeps those that bend by more than 30 degrees, or none. The grading's `edge` must be finite; 0:
// as long as makes about 2,000 cells.
//
// The mesher is CGAL's Delaunay refinement with protected edges [1]; slivers are made rounder by
// round_slivers(), and where some keep an angle below 3 degrees shorter edges are tried, down to a
// third. Angles between faces are mostly above 8 degrees, less where edges of the cage are shorter
// or sharper than cells can be. About 80 us per cell. Throws Rejected unless the surface
// is closed, has at most 20,000 faces, each edge has two of them, and it does not cross itself;
// where there would be about twice as many cells as the limit; and where the mesher gives up. Faces
// may be turned to either side. One thread, so always the same bits.
//   [1] Jamin, Alliez, Yvinec, Boissonnat, CGALmesh: a generic framework for Delaunay mesh
//   generation, 2015
CageCells cage_cells(std::span<const glm::dvec3> positions,
                     std::span<const std::array<int, 3>> triangles, const Grading& grading);

} // namespace trivar
