// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/ffd/verdict.h"

namespace trivar {

// Whether far parts of one volume meet.
struct Overlap {
    // Good: no two points of the domain have the same place. Bad: `one` and `other` do. Unknown:
    // neither could be proven, also where the volume folds, jumps, or only touches itself.
    Verdict verdict = Verdict::unknown;
    glm::dvec3 one{0}, other{0}; // uvw: the witness, or where it stayed unknown
    int pairs = 0;               // of pieces looked at
};

struct OverlapOptions {
    int pairs = 200000;
    int halvings = 6; // of a cell along each axis
};

// det J > 0 everywhere and a boundary that meets itself nowhere make a map injective; see
// docs/injectivity.md. So pieces of the boundary are compared, halved where nothing is clear: far
// ones are separated by the hulls of their control points; near ones, shared edges included, do not
// meet where J stays nearer than 1 to its value in the middle of the box round both. Volumes closed
// along two axes have two boundaries: there all cells are compared. Never good where judge() is
// not. 0.05 s for 20 x 12 x 8.
Overlap overlap(const Lattice& lattice, const OverlapOptions& options = {},
                const Progress& progress = {});

} // namespace trivar
