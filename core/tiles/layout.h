// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/runs.h"
#include "core/tiles/random_share.h"
#include "core/tiles/strand.h"
#include "core/tiles/stroke_track.h"
#include "core/tiles/tile.h"
#include "core/tiles/tile_curvature.h"
#include "core/tiles/tile_stroke.h"

namespace trivar {

struct TileLayout {
    Runs<Tile> tiles;
    StrandLayout strands;            // laid end to end, besides
    std::vector<StrokeTrack> tracks; // of the strokes that lay tiles in lines
    double duration_s = 0;           // of all strokes that lay tiles
    int lost = 0;                    // number of samples that are on no surface any more
    bool too_many = false; // there would be more than most_tiles, or too many tries found no room
};

} // namespace trivar
