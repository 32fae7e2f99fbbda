// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/verdict.h"

namespace trivar {

// The least det J of the map uvw -> world at samples^3 points of every cell, ends included. What it
// finds is true, what it misses it misses. O(cells x samples^3 x order^3). samples >= 2.
double smallest_jacobian(const Lattice& lattice, int samples);

// Whether a lattice folds space over.
struct Injectivity {
    // Of det J having the sign of the whole deformed volume everywhere. Good: no point meets its
    // neighbours (one cell of a lattice of order 2 never meets the kinks between cells).
    Verdict local = Verdict::proven_good;
    // Proven that no two points whatever meet: J stays nearer than 1 to its mean. Strong bends are
    // beyond this criterion, so false says nothing.
    bool global = false;
    // The parts of the domain that are not proven good. In a proven_bad one det J has the wrong
    // sign somewhere.
    std::vector<DoubtfulPart> parts;
};

// det J of a cell is a polynomial of degree 3d - 1; its Bernstein coefficients bound it and those
// of the corners are values. Where that leaves both signs possible, boxes are halved up to
// `depth` times along every axis, within a budget. About 0.01 ms a tri-cubic cell.
Injectivity check_injectivity(const Lattice& lattice, int depth = 4);

} // namespace trivar
