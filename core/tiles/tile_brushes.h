// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/laid_tiles.h"
#include "core/tiles/tile_stroke.h"

namespace trivar {

// Lets a brush that lays no tiles change those that are under it: erase, comb, resize, raise, color
// and morph. Each tile follows the step of the stroke that is nearest to it. O(#steps #tiles near
// each).
void change_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path);

// Applies the brushes color and morph to a tile, `much` of them.
void change_look(glm::dvec3& tint, double& morph, const TileStroke& stroke, double much);

// A hand takes single tiles: for each step the one that is nearest, within half of its size. The
// second path is the mirror image of the first, or empty; no tile is taken for both.

// Moves them so that the one of the first step comes to the last one, which takes none, if there
// are two; the others go along over the surface, and all turn as it turns.
void grab_tiles(LaidTiles& laid, const std::vector<StrokeStep>& path,
                const std::vector<StrokeStep>& mirrored);

// Turns and scales them where they are; those that become nothing are gone.
void adjust_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path,
                  const std::vector<StrokeStep>& mirrored);

} // namespace trivar
