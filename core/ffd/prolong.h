// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/lattice.h"

namespace trivar {

// The same function over a longer axis (0: u, 1: v, 2: w), which must be open and clamped. Beyond
// its domain, from `from` <= begin and to `to` >= end, it continues straight with a continuous
// derivative. Exact; control points away from the ends keep their bits. How long the axis becomes
// changes nothing between its ends. O(number of control points).
Lattice prolonged(const Lattice& lattice, int axis, double from, double to);

// The same function over all parameters in a box, prolonged along each open axis in whole quarters
// of that axis's domain: boxes that differ by less mostly get equal lattices.
Lattice prolonged_round(const Lattice& lattice, const Box& uvw);

// A lattice that runs twice through one whose ends u = begin and u = end meet: F(u + period) =
// F(u). The seam is as smooth as the ends meet there.
Lattice twice_round(const Lattice& lattice);

} // namespace trivar
