// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/mesh.h"
#include "core/tiles/tile_patch.h"

namespace trivar {

// A TileCell is the box of a model that becomes the tile: its middle stands on the middle of the
// patch, its longer side along x or y fills the patch, and its floor lies on the base.
struct TileCell {
    glm::dvec3 middle_of_floor{0};
    double side = 1; // metres
    double top = 1;  // height over the floor
};

// A PlacedTile is a patch with the factor of z: metres in the world per unit of the tile's height.
struct PlacedTile {
    TilePatch patch;
    double height = 1; // metres in the world of what is one `side` high
    double base = 0;   // added to z, metres in the world
};

// One mesh of all tiles: copies of a mesh, each bent over its patch. Normals are exact, by
// cofactors of the derivatives of T. The mesh is taken to the cell's model by `to_model`. In
// parallel; the same bits for any number of threads. O(#tiles #V).
Ref<Mesh> bent_tiles(const Mesh& mesh, const glm::dmat4& to_model, const TileCell& cell,
                     std::span<const PlacedTile> tiles);

} // namespace trivar
