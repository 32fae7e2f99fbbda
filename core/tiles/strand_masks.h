// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/strand.h"
#include "core/tiles/tile_masks.h"

#include <span>

namespace trivar {

// Applies masks to strands, by their factors at the stations (#stations). Scale is a factor of
// width and height there, height of the height alone, so that tiles that meet stay as wide and as
// high. Density leaves out cells and morph is that of a cell, each by its mean over the cell; the
// other cells stay where they are. O(#stations + #cells).
void mask_strands(StrandLayout& layout, std::span<const MaskFactors> factors);

} // namespace trivar
