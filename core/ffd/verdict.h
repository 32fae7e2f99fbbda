// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/cell_determinants.h"

namespace trivar {

// A Verdict says whether det J has one sign everywhere in a part of a lattice. Excepted: declared
// not to be judged.
enum class Verdict { proven_good, proven_bad, unknown, excepted };

// The verdict on a cell from the coefficients alone, where det J should have the sign `sign`: all
// coefficients bound it, and those of the corners are values.
Verdict verdict_at_once(const CellDeterminant& det, int sign);

struct DoubtfulPart {
    glm::dvec3 lo, hi; // uvw
    Verdict verdict;   // proven_bad or unknown
};

// A Halving says how far a cell is halved while its coefficients leave both signs possible.
struct Halving {
    int depth = 4;          // largest number of times along every axis
    int boxes = 512;        // largest number of boxes looked at per cell
    bool until_bad = false; // stop at the first part that is proven bad
};

// The parts of a cell that are not proven good, the worst first; empty: the cell is good.
std::vector<DoubtfulPart> doubtful_parts(const CellGrid::Place& cell, const CellDeterminant& det,
                                         int sign, const Halving& halving);

} // namespace trivar
