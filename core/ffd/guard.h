// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/verdict.h"

namespace trivar {

// CellVerdicts says for every cell of a lattice whether det J has the right sign there. If all
// cells are good, no point meets its neighbours; distant parts may still meet: see overlap.h.
struct CellVerdicts {
    std::array<std::vector<double>, 3> breaks; // uvw; one more than cells along each axis
    std::vector<Verdict> of;                   // cells, w fastest
    // The least Bernstein coefficient of sign * det J in each cell, which is a lower bound of it.
    // It is 0 in excepted cells, which were not looked at, and where a coefficient is not a number.
    std::vector<double> least;
    int sign = 1;            // the sign that det J must have
    double typical = 0;      // size of the mean of det J over the domain: the scale for `least`
    glm::ivec3 size() const; // cells along u, v and w
    bool good() const;       // no cell is bad or unknown
};

struct GuardOptions {
    // The declared exceptions: cells that overlap one of these boxes of uvw are not judged.
    std::vector<Box> excepted = {};
    Halving halving{6, 256, true};
    // The sign that det J must have, as when the volume was laid; 0: its sign in most of the
    // volume.
    int sign = 0;
    int steps = 256; // shares are multiples of 1 / steps
};

// Judges all cells of a lattice. Cost for tri-cubic ones: 5 ms per 1000 cells on two threads, if
// few are doubtful.
CellVerdicts judge(const Lattice& lattice, const GuardOptions& options = {});

// Judges only the touched cells again.
//   before  the verdicts before control points were moved; their sign stays
//   now     the lattice after the moves
//   moves   which control points moved; how far does not matter
CellVerdicts judged_again(CellVerdicts before, const Lattice& now, std::span<const PointMove> moves,
                          const GuardOptions& options = {});

// A CertifiedShare is the largest share of a move, a multiple of 1 / steps, that the guard allows.
// The moved lattice is proven good in all touched cells that were good. A touched cell that was bad
// or unknown is proven good, or none of its coefficients fell that is below 0 afterwards. The share
// is searched by halving, and the result itself was judged. 0: no move at all.
struct CertifiedShare {
    double share = 1;
    std::vector<int> stopping; // cells that forbade a larger share; empty where it is 1
    CellVerdicts after;        // of moved(from, scaled(moves, share))
};
CertifiedShare certified_share(const Lattice& from, const CellVerdicts& before,
                               std::span<const PointMove> moves, const GuardOptions& options = {});
// Judges the lattice first and returns the certified share of a single edit.
double certified_share(const Lattice& from, std::span<const PointMove> moves,
                       const GuardOptions& options = {});

std::vector<PointMove> scaled(std::span<const PointMove> moves, double share);

} // namespace trivar
