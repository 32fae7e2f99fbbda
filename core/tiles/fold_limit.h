// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"

#include <span>
#include <vector>

namespace trivar {

// Returns the height up to which a tile on the patch surely does not fold: the determinant of the
// derivatives of T is positive over the whole unit square for every z from 0 to that height. Zero:
// the patch turns over in itself; infinity: it never folds. A side that is a single point, to the
// last bit, may be one: the determinant is positive up to it.
//   most_quartered  how often the piece of the patch with the lowest limit is quartered at most
// About 3 us.
double fold_limit(const TilePatch& patch, int most_quartered = 8);

// The same for many patches: the same bits, about a microsecond each.
std::vector<double> fold_limits(std::span<const TilePatch> patches, int most_quartered = 8);

// The share of its limit that a tile which is lowered gets: positions are rounded.
inline constexpr double proven_share = 0.98;

} // namespace trivar
