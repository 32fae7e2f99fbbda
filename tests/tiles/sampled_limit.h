// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"

namespace trivar::testing {

// The least height at which one of 33 x 33 samples of the patch turns over; 1e300: none does. At
// each sample the determinant is a quadratic of the height, which may be positive again above its
// second root.
double sampled_limit(const TilePatch& patch);

// The patch with lengths in sides of its tile, so that heights are in sides, too.
TilePatch in_sides(TilePatch patch, double size);

} // namespace trivar::testing
