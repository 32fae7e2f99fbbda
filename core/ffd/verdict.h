// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/cell_determinants.h"

namespace trivar {

// Of det J having one sign everywhere in a part of a lattice. Excepted: declared not to be judged.
enum class Verdict { proven_good, proven_bad, unknown, excepted };

// What the coefficients alone say of a cell where det J should have the sign of `sign`: all of them
// bound it, those of the corners are values.
Verdict verdict_at_once(const CellDeterminant& det, int sign);

struct DoubtfulPart {
    glm::dvec3 lo, hi; // uvw
    Verdict verdict;   // proven_bad or unknown
};

// How far a cell is halved where its coefficients leave both signs possible.
struct Halving {
    int depth = 4;          // times along every axis
    int boxes = 512;        // looked at in a cell
    bool until_bad = false; // stop at the first part that is proven bad
};

// The parts of a cell that are not proven good; none: the cell is. Worst first.
std::vector<DoubtfulPart> doubtful_parts(const CellGrid::Place& cell, const CellDeterminant& det,
                                         int sign, const Halving& halving);

} // namespace trivar
