// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"

namespace trivar {

// A Tile is one tile as strokes have laid it.
struct Tile {
    SurfacePlace at;
    glm::dvec3 x{1, 0, 0}; // unit, in the plane of the normal at its middle
    double size = 0;       // side, metres on the model
    double height = 1;     // factor
    std::uint32_t seed = 0;
    int stroke = 0;        // number of the stroke that laid it; -1: none, it belongs to a cover
    double time_s = 0;     // since the first stroke began; the strokes follow each other at once
    glm::dvec3 tint{1};    // factor of the colours of its material, linear
    double morph = 0;      // -1..1, added to that of its layer
    int track = -1;        // number of the track of its layout on which it was laid; -1: none
    double along = 0;      // length of that track up to it, metres on the model
    bool mirrored = false; // it is a mirror image: its y axis points to the other side
    bool operator==(const Tile&) const = default;
};

// Gives the angle about the normal by which a turn of all tiles turns this one.
inline double turn_of(const Tile& tile, double turn)
{
    return tile.mirrored ? -turn : turn;
}

} // namespace trivar
