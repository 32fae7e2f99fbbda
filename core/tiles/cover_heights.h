// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/covered_tiles.h"

namespace trivar {

// Gives the heights of a CoveringPose whose points are set: at a corner of cells, the mean length
// along its row of the cells round it, times a factor. O(#cells).
std::vector<double> heights_along_rows(const Covering& covering,
                                       std::span<const SurfacePoint> points, double factor);

// GuardedHeights are heights at which no cell folds, with the cells that had to change.
struct GuardedHeights {
    std::vector<double> heights;       // of the nodes
    std::vector<char> lowered, folded; // of the cells
    // The greatest height of each cell as a share of the proven limit; above 1 it was lowered, and
    // 0 means that the cell folds in itself.
    std::vector<double> of_limit = {};
};
// Lowers heights at corners until no cell folds: a corner as far as the cells round it need, so
// that tiles that meet stay equally high there. Cells that fold in themselves are marked and lower
// nothing.
//   top  height below which nothing may fold, in lengths of a tile
// In parallel; about 10 us per cell.
GuardedHeights guarded_heights(const Covering& covering, const CoveringPose& pose, double top);

} // namespace trivar
