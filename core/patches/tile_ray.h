// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_set.h"

#include <optional>

namespace trivar {

// Finds the tile of a set that the line origin + t along, t > 0, meets first, nearer than a t;
// nothing: it meets none. In the space of the tiles. Only tiles whose hull the line meets are bent:
// O(#tiles), and O(#C) for each of those.
struct TileHit {
    std::size_t tile = 0;
    double t = 0;
};
std::optional<TileHit> first_tile(const TileSet& set, const glm::dvec3& origin,
                                  const glm::dvec3& along, double nearer_than);

} // namespace trivar
