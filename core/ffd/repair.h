// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/ffd/repair_options.h"

namespace trivar {

// A RepairWay is a way to move control points so that a lattice no longer folds.
enum class RepairWay {
    smoothed_directions, // columns turned toward the directions of their neighbours
    lowered_heights,     // columns kept under a cap
    monotone_columns,    // layers put back in order along the ground's normal
    evened,              // points round a fold moved to the middle of their neighbours
    relaxed,             // each fold opened by the smallest moves of the points round it
};

struct RepairAttempt {
    RepairWay way = RepairWay::relaxed;
    bool ground_yields = false; // tried only where nothing else helps
    bool certified = false;
    double moved_rms = 0, moved_most = 0; // world, over all control points
};

// An UnfoldedLattice is the result of unfolded(), which finds the smallest change after which every
// cell is proven good. All ways are tried, each only as far as it needs, and the one that moves
// control points least (root of the mean square) is taken. Control points whose sites lie in a
// declared exception stay. The same on every machine.
struct UnfoldedLattice {
    Lattice lattice;              // the given lattice where nothing helped or nothing was wrong
    bool certified = false;       // all cells are proven good
    std::vector<PointMove> moves; // from the given lattice; few where there are few folds
    RepairAttempt taken;          // empty where nothing was wrong
    std::vector<RepairAttempt> tried;
};
UnfoldedLattice unfolded(const Lattice& lattice, const RepairOptions& options = {},
                         const Progress& progress = {});

} // namespace trivar
