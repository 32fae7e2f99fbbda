// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/guard.h"

namespace trivar::testing {

// The least det J of the map uvw -> world at samples^3 points of each cell, ends included: what it
// finds is true, what it misses it misses. samples >= 2.
double smallest_jacobian(const Lattice& lattice, int samples);

// Returns the verdict on all cells together: bad where one is, good where all are.
Verdict verdict_of(const Lattice& lattice);

} // namespace trivar::testing
