// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/runs.h"
#include "core/tiles/near_tiles.h"
#include "core/tiles/tile.h"

namespace trivar {

// A StrokeStep is a sample of a stroke on the present base; samples that are on no surface are left
// out.
struct StrokeStep {
    SurfacePlace at;
    glm::dvec3 p, n;  // metres on the model; unit
    glm::dvec3 ahead; // the direction of the stroke, unit, in the plane of the normal
    double time_s, pressure;
    bool operator==(const StrokeStep&) const = default;
};

// LaidTiles are the tiles of a layout while its strokes are worked off.
struct LaidTiles {
    const TileBase& base;
    Runs<Tile> tiles;
    Runs<char> gone; // by tile: a brush removed it
    NearTiles near;  // by number

    void add(const Tile& tile)
    {
        near.add(base.position(tile.at), static_cast<int>(tiles.size()));
        tiles.push_back(tile);
        gone.push_back(0);
    }
};

} // namespace trivar
