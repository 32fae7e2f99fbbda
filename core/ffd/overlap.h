// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/ffd/verdict.h"

namespace trivar {

// An Overlap says whether distant parts of one volume meet.
struct Overlap {
    // Good: no two points of the domain have the same place. Bad: `one` and `other` have the same
    // place. Unknown: neither was proven; also where the volume folds, jumps, or only touches
    // itself.
    Verdict verdict = Verdict::unknown;
    glm::dvec3 one{0}, other{0}; // uvw: the witness, or where it stayed unknown
    int pairs = 0;               // number of pairs of pieces that were compared
};

struct OverlapOptions {
    int pairs = 200000;
    int halvings = 6; // largest number for a cell, along each axis
};

// A map is injective if det J > 0 everywhere and its boundary does not meet itself; see
// docs/injectivity.md. So pieces of the boundary are compared, and halved where nothing is clear.
// Distant pieces are separated by the hulls of their control points. Near pieces, also those with a
// shared edge, do not meet where J stays nearer than 1 to its value in the middle of the box round
// both. Volumes closed along two axes have two boundaries: there all cells are compared. Never good
// where judge() is not. 0.05 s for 20 x 12 x 8.
Overlap overlap(const Lattice& lattice, const OverlapOptions& options = {},
                const Progress& progress = {});

} // namespace trivar
