// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

namespace trivar {

// The same function over a longer u axis, which must be open and clamped: from the end of its
// domain at `from` <= begin and `to` >= end straight on, with a continuous derivative. Exact;
// control points away from the ends keep their bits. O(control points).
Lattice prolonged(const Lattice& lattice, double from, double to);

// A lattice whose ends u = begin and u = end meet, run through twice: F(u + period) = F(u), as
// smooth at the seam as the ends meet there.
Lattice twice_round(const Lattice& lattice);

} // namespace trivar
