// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/lattice.h"

namespace trivar {

// Prolongs a lattice along one axis, exactly.
//   axis      0 u, 1 v or 2 w; open and clamped
//   from, to  the new ends: from <= begin, to >= end; the function continues straight beyond the
//             domain, with a continuous derivative
// Control points away from the ends keep their bits, and the new length changes nothing between the
// old ends. O(#control points).
Lattice prolonged(const Lattice& lattice, int axis, double from, double to);

// The same function over all parameters in a box, prolonged along each open axis in whole quarters
// of that axis's domain: boxes that differ by less mostly get equal lattices.
Lattice prolonged_round(const Lattice& lattice, const Box& uvw);

// A lattice that runs twice through one whose ends u = begin and u = end meet: F(u + period) =
// F(u). The seam is as smooth as the ends meet there.
Lattice twice_round(const Lattice& lattice);

} // namespace trivar
