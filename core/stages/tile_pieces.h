// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_set.h"

#include <functional>
#include <optional>

namespace trivar {

// TilePieces are the tiles of a set, sorted by the sides of cuts on which all of a tile is.
struct TilePieces {
    // Tiles through which no cut goes, by their sides: bit i means above cut i.
    std::vector<std::pair<unsigned, Ref<TileSet>>> whole;
    Ref<Mesh> crossed; // all tiles that a cut may go through, as one mesh; null: none
};

// Returns the sides of cuts on which all of a box is; none: a cut may go through it.
using SidesOfBox = std::function<std::optional<unsigned>(const Box&)>;

// Sorts the tiles by their hulls.
//   alone     the mesh of the set is that of its tiles bent one by one; another mesh cannot be
//             taken apart, and is crossed as a whole
//   sides_of  the sides of cuts on which a box is
//   kept      whether tiles on some sides are kept
// Tiles that are not crossed are not bent. 2 us per tile in runs that are divided.
TilePieces tile_pieces(const Ref<TileSet>& set, bool alone, const SidesOfBox& sides_of,
                       const std::function<bool(unsigned sides)>& kept);

} // namespace trivar
