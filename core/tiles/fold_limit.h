// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"

namespace trivar {

// The height up to which a tile on the patch surely does not fold: the determinant of the
// derivatives of T is positive over the whole unit square for every z from 0 to that height. Zero:
// the patch turns over in itself; infinity: it never folds. A side that is a single point, to the
// last bit, may be one: the determinant is positive up to it. `depth` is how often the patch is
// halved where that lifts the limit; 2 calls 0.3 % of the tiles folded that are not. About 10
// microseconds.
double fold_limit(const TilePatch& patch, int depth = 2);

} // namespace trivar
