// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/laid_tiles.h"

namespace trivar {

// Lets a brush that lays no tiles change those that are under it: erase, comb, resize, raise. Each
// tile follows the sample of the stroke that is nearest to it. O(#samples #tiles near each).
void change_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path);

// Takes the tile that is nearest to the first step, within half of its size, to the last one.
void grab_tile(LaidTiles& laid, const std::vector<StrokeStep>& path);

} // namespace trivar
