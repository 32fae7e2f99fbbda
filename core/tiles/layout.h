// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/tiles/strand.h"

namespace trivar {

// A Tile is one tile as strokes have laid it.
struct Tile {
    SurfacePlace at;
    glm::dvec3 x{1, 0, 0}; // unit, in the plane of the normal at its middle
    double size = 0;       // side, metres on the model
    double height = 1;     // factor
    std::uint32_t seed = 0;
    int stroke = 0;    // number of the stroke that laid it
    double time_s = 0; // since the first stroke began; the strokes follow each other at once
    bool operator==(const Tile&) const = default;
};

struct TileLayout {
    std::vector<Tile> tiles;
    StrandLayout strands;  // laid end to end, besides
    double duration_s = 0; // of all strokes that lay tiles
    int lost = 0;          // number of samples that are on no surface any more
    bool too_many = false; // there would be more than most_tiles, or too many tries found no room
};

// Works the strokes off in their order. Pure: a tile's seed comes from its stroke and its number in
// it, so that editing one stroke leaves the tiles of others, except where they avoid each other.
// About 5 microseconds per try. Throws Cancelled.
TileLayout layout_of(const TileBase& base, const std::vector<Ref<TileStroke>>& strokes,
                     const Progress& progress = {});

// A number of [0, 1) for a seed and a purpose: the same for ever.
double random_share(std::uint32_t seed, std::uint32_t purpose);

} // namespace trivar
