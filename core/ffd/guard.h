// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/verdict.h"

namespace trivar {

// What is known of every cell of a lattice: whether det J has the right sign there.
// Good everywhere: no point meets its neighbours. Far parts may still meet: see overlap.h.
struct CellVerdicts {
    std::array<std::vector<double>, 3> breaks; // uvw; one more than cells along each axis
    std::vector<Verdict> of;                   // cells, w fastest
    // The least Bernstein coefficient of sign * det J in each cell, a lower bound of it; 0 in
    // excepted cells, which were not looked at, and where it is not a number.
    std::vector<double> least;
    int sign = 1;            // that det J is to have
    double typical = 0;      // size of its mean over the domain: what `least` compares with
    glm::ivec3 size() const; // cells along u, v and w
    bool good() const;       // no cell is bad or unknown
};

struct GuardOptions {
    // Declared exceptions: cells that overlap one of these boxes of uvw are not judged.
    std::vector<Box> excepted = {};
    Halving halving{6, 256, true};
    // That det J is to have, as when the volume was laid; 0: what it has in most of the volume.
    int sign = 0;
    int steps = 256; // shares are multiples of 1 / steps
};

// All cells. Tri-cubic: 5 ms for 1000 on two threads where few are doubtful.
CellVerdicts judge(const Lattice& lattice, const GuardOptions& options = {});

// The same after control points were moved: only the cells they touch are looked at again, for the
// sign the volume had. By how much does not matter.
CellVerdicts judged_again(CellVerdicts before, const Lattice& now, std::span<const PointMove> moves,
                          const GuardOptions& options = {});

// The largest share, a multiple of 1 / steps, by which control points may go: the moved lattice is
// proven good in all touched cells that were, and where one was bad or unknown, it is proven good
// or no coefficient that is below 0 has fallen, nor come to be below. Searched by halving, but what
// is returned was judged as it is returned. 0: not at all.
struct CertifiedShare {
    double share = 1;
    std::vector<int> stopping; // cells that forbade a larger one; empty where it is 1
    CellVerdicts after;        // of moved(from, scaled(moves, share))
};
CertifiedShare certified_share(const Lattice& from, const CellVerdicts& before,
                               std::span<const PointMove> moves, const GuardOptions& options = {});
// For a single edit: judges the lattice first.
double certified_share(const Lattice& from, std::span<const PointMove> moves,
                       const GuardOptions& options = {});

std::vector<PointMove> scaled(std::span<const PointMove> moves, double share);

} // namespace trivar
