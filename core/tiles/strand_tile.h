// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/patches/placed_tile.h"

#include <span>

namespace trivar {

// A StrandTile is a tile in the unit cell of a strand, made ready to meet its neighbours: matching
// points of both ends are snapped to the end planes and to equal offsets.
struct StrandTile {
    Mesh mesh;
    int unmatched = 0; // number of points of open edges at an end without their like at the other
};
StrandTile strand_tile(Mesh in_unit_cell);

// Makes one mesh of tiles on their patches, in double precision throughout: tiles whose patches
// meet have their common points with the same bits. In parallel; about 0.3 microseconds per vertex.
Mesh strand_mesh(const Mesh& unit, std::span<const PlacedTile> tiles);

} // namespace trivar
