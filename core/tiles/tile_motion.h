// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"
#include "core/tiles/layout.h"

#include <optional>

namespace trivar {

// A TileMotion is the effect of the growth and the wave of a layer on one tile at a frame.
struct TileMotion {
    double size = 1;   // factor of its sides and of its height; 0: it is not there yet
    double height = 1; // factor of its height alone
    bool operator==(const TileMotion&) const = default;
};

// `p` is the middle of the tile on the base at rest. Tiles grow in the order in which their strokes
// laid them; the wave goes along its direction through the model's space.
TileMotion motion_of(const TileLook& look, const TileLayout& layout, const Tile& tile,
                     const glm::dvec3& p);

// Returns the morph of the tiles that are behind the others by that share, from 0 to 1. Waiting
// tiles keep their shape, and finished ones keep their morph.
double morph_of(const TileLook& look, double share);

// A tile that has slid over the base as far as the look says, with its x axis carried along;
// nothing where a border stopped it. O(#edges crossed).
std::optional<Tile> slid(const TileBase& base, const Tile& tile, const TileLook& look);

// A tile that has gone along the track on which it was laid, by a number of the track's `sides`,
// with its x axis at the same angle to it; nothing beyond the ends of a track that is not closed.
std::optional<Tile> slid_along(const TileBase& base, const Tile& tile, const StrokeTrack& track,
                               double sides);

// Returns the layout with all tiles slid; those that a border or the end of their track stopped are
// infinitely large, so that they get no chart. In parallel.
TileLayout slid_layout(const TileBase& base, const TileLayout& layout, const TileLook& look);

// Returns the middle part of a patch whose sides are `share` as long, as a patch of its own: exact,
// since polynomials stay polynomials. About 2 us.
TilePatch middle_of(const TilePatch& patch, double share);

} // namespace trivar
