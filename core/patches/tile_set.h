// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/base/ref.h"
#include "core/patches/tile_kernel.h"
#include "core/patches/tile_levels.h"

namespace trivar {

// A TileCell is the box of a model that becomes the tile: its middle stands on the middle of the
// patch, its longer side along x or y fills the patch, and its floor lies on the base.
struct TileCell {
    glm::dvec3 middle_of_floor{0};
    double side = 1;  // metres
    double top = 1;   // height over the floor
    double reach = 1; // how many times as wide as its place the tile is, about its middle
    bool operator==(const TileCell&) const = default;
};

// Moves a mesh into the unit cell: x and y fill the unit square, z is in sides and 0 on the floor.
// `to_model` takes the mesh to the cell's model; a mirroring one turns the faces round. Skins,
// morph targets and creases are left out. O(#V).
Mesh in_unit_cell(const Mesh& mesh, const glm::dmat4& to_model, const TileCell& cell);
// The same by a matrix from the mesh to the unit cell.
Mesh in_unit_cell(const Mesh& mesh, const glm::dmat4& to_unit);

// A TileModel is one tile in its unit cell, for any number of places.
struct TileModel {
    Ref<Mesh> mesh;
    Box box;                             // of the mesh
    Lazy<std::vector<TileLevel>> levels; // levels_of() the mesh
};
// `with_levels`: one that stands still, whose levels are worth their time; else the mesh is the
// only one.
Ref<TileModel> tile_model(Mesh in_unit_cell, bool with_levels = true);

// A TileSet is a mesh repeated over patches. The processor bends all of them when the mesh is first
// read, which does not happen where the graphics card draws.
struct TileSet {
    struct Extent {
        Box hull;           // holds every point of the tile
        double stretch = 0; // stretch_bound()
    };
    Ref<TileModel> model;
    Ref<PlacedTiles> tiles;
    Runs<Extent> extents;   // #tiles, in runs as theirs
    std::vector<Box> hulls; // of each run
    Box box;                // of all vertices, in double precision
    Lazy<Ref<Mesh>> mesh;
    std::size_t vertex_count() const { return model->mesh->vertex_count() * tiles->size(); }
    std::size_t face_count() const { return model->mesh->face_count() * tiles->size(); }
};
// Makes a set of tiles: bounds all of them, and bends only the few whose hulls reach out of the box
// of the others. `before`: runs of tiles that it has, too, cost nothing. In parallel, about 2 us
// per tile.
Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<PlacedTiles>& tiles,
                      const Ref<TileSet>& before = nullptr);
// Makes a set of tiles for which a better mesh than that of the patches exists. `mesh`: as many
// vertices and faces, tile by tile, each about where its patch has it.
Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<PlacedTiles>& tiles,
                      Lazy<Ref<Mesh>> mesh, const Ref<TileSet>& before = nullptr);

// Makes one mesh of all tiles. In parallel; the same bits for any number of threads. O(#tiles #V).
Mesh bent_tiles(const Mesh& unit, std::span<const PlacedTile> tiles);
Mesh bent_tiles(const Mesh& unit, const PlacedTiles& tiles);

// Multiplies the colours of copies of a tile, one behind another, by the tints of their places;
// copies without colours get them where a place is tinted.
void tint_copies(Mesh& copies, std::span<const PlacedTile> tiles);

// Finds the vertices of every tile that are furthest out along 26 directions of its cell, by which
// a view frames them. In the world, metres, double precision; at most 26 per tile.
std::vector<glm::dvec3> outer_points(const TileModel& model, const PlacedTiles& tiles);

} // namespace trivar
