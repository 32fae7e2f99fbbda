// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/tiles/random_share.h"
#include "core/tiles/strand.h"
#include "core/tiles/stroke_track.h"
#include "core/tiles/tile.h"
#include "core/tiles/tile_curvature.h"
#include "core/tiles/tile_stroke.h"

namespace trivar {

struct TileLayout {
    std::vector<Tile> tiles;
    StrandLayout strands;            // laid end to end, besides
    std::vector<StrokeTrack> tracks; // of the strokes that lay tiles in lines
    double duration_s = 0;           // of all strokes that lay tiles
    int lost = 0;                    // number of samples that are on no surface any more
    bool too_many = false; // there would be more than most_tiles, or too many tries found no room
};

// Works the strokes off in their order. Pure: a tile's seed comes from its stroke and its number in
// it, so that editing one stroke leaves the tiles of others, except where they avoid each other.
// About 5 microseconds per try. `curvature`: of the base, asked for where tiles head along it;
// null: it is estimated then. Throws Cancelled.
TileLayout layout_of(const TileBase& base, const std::vector<Ref<TileStroke>>& strokes,
                     const Progress& progress = {}, const Lazy<TileCurvature>* curvature = nullptr);

} // namespace trivar
