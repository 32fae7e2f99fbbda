// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"
#include "core/simplex/cell_displacements.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_volume.h"
#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

struct Conversion {
    int degree = 3;        // 1..3
    int pieces = 1;        // into which each span is cut along each axis
    CloudStyle style = {}; // of the knots
};

struct ConvertedLattice {
    SimplexVolume volume; // of one layer, over the world as it was at rest
    // The distance between the volume's and the lattice's images of points, sampled at 35 places in
    // each cell: the most and the root of the mean square, in world units.
    double most = 0, mean = 0;
    CellDisplacements values = {};       // by which the volume's are made
    std::vector<Crease<3>> creases = {}; // of its domain
    double spread = 0;                   // of its clouds
};

// Converts a lattice to a simplex spline: each span (or piece of it) becomes a box of 6 tetrahedra
// round its diagonal, and the breaks of its knots stay. Where a knot makes it less smooth than the
// spline, faces are creased, which is met nearly; where its slopes jump, they are seams, and where
// it is torn, cuts, which are both met exactly: a lattice of order 2 by degree 3. Control points
// are polar forms, at the knots of their functions, of the polynomial through the lattice's
// displacements in their cell [1]: displacements that are polynomials of at most the degree are met
// to rounding, others to the order degree + 1 in the size of the spans; a lattice at rest is met
// exactly. A closed axis counts as one period. Throws Rejected if the lattice is flat at rest or
// would need more than 10^6 cells. About 1 ms per cell and core for degree 3, most of it to look.
//   [1] Serghini, Tijini, New approach to study splines by blossoming method and application to
//   the construction of a bivariate C1 quartic quasi-interpolant, 2015
ConvertedLattice from_lattice(const Lattice& lattice, const Conversion& how = {});

// The shape whose volume that is, to be edited further. O(number of faces times creases).
TetrahedraShape shape_of(const ConvertedLattice& converted);

// Whether a shape was a lattice and has the degree and the spread of its conversion, for which its
// deviation holds. Of conversions in the usual style alone.
bool is_as_converted(const TetrahedraShape& shape);

} // namespace trivar
