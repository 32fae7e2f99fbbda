// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/grading.h"

#include <span>

namespace trivar {

// A CellFilling says how cells fill a place. Its grading's `edge` must be finite; 0: as long as
// makes about 2,000 cells in the box around the model.
struct CellFilling {
    Grading grading{.edge = 0};
    double margin = 0; // distance of the border from the model, in addition to what cells need:
                       // 0.7 edges
    double least_angle = 0.26; // radians between faces of a cell (15 degrees); 0 .. 0.6: where it
                               // would be less the border stays rough
};

struct FilledCells {
    SimplexMesh<3> mesh;
    double edge = 0;     // what the grading's was, or more: then the cells would have been too many
    bool capped = false; // edges are longer than asked, because of the limit of cells
    double smooth = 0;   // share of the border's vertices that lie at the wanted distance, to 5 %
                         // of an edge; the others lie nearer to where the lattice had them
};

// Cells around a model, all of it, with a border that follows it at a distance of 0.7 edges plus
// the margin; holes narrower than twice that are closed, and what they enclose is filled. Every
// vertex of the model lies in a cell, and its faces too but where the border stayed rough. The
// model may be open, crossing itself, wrongly oriented, flat or of points alone (an empty list of
// triangles); throws Rejected where it is empty, not finite or names vertices that it has not.
//
// These are the cells of a body-centred cubic lattice, halved where they are to be finer, whose
// mean distance is less than that, with their border drawn to it as far as angles allow. That is
// isosurface stuffing [1] with a bound on angles that is kept by looking rather than by the choice
// of cuts, and with graded cells as good as equal ones. No vertex or edge is where only two parts
// of the domain meet. The same bits for any number of threads.
//   [1] Labelle, Shewchuk, Isosurface stuffing: fast tetrahedral meshes with good dihedral angles,
//   2007
FilledCells cells_around(std::span<const glm::dvec3> positions,
                         std::span<const std::array<int, 3>> triangles, const CellFilling& filling);

} // namespace trivar
