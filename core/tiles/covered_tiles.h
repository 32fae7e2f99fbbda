// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/limit/chart_uvs.h"
#include "core/mesh/height_sheet.h"
#include "core/mesh/mesh.h"
#include "core/patches/placed_tile.h"
#include "core/tiles/covering.h"

#include <functional>

namespace trivar {

// A CoveringPose is a covering as its base stands at a frame, with how high its tiles are.
struct CoveringPose {
    std::vector<SurfacePoint> points; // of the covering's nodes, in the world
    // The height in the world, in metres, of a tile as high as its model is long: at every node
    // that is a corner of cells. Between corners it is bilinear, so that tiles that meet are
    // equally high there.
    std::vector<double> heights;
    // Whether the posed base is mirrored relative to rest, by chart.
    std::vector<char> mirrored;
    // Factors, by tile, of heights, and of lengths and widths about their middles. Empty: 1.
    std::vector<double> factors = {}, scales = {};
};

// A CoverCell is the box of a model that becomes the tile; it is stretched along x and y until it
// fills the cell.
struct CoverCell {
    glm::dvec3 lo{0}, size{1}; // metres
    double sink = 0;           // how deep it stands in the base, as a share of its height
    double scale = 1;          // factor of its length and width, about its middle
    int turns = 0;             // quarter turns about its middle
    bool operator==(const CoverCell&) const = default;
};

// Makes one mesh of tiles of a covering: copies of a mesh, each bent over its cells.
//   to_model  from the mesh to the model of `cell`
//   pose      the covering at the frame, world
//   tiles     numbers of tiles of the covering
// Normals are exact, by cofactors. A vertex on a side of its tile has the same bits as that of the
// tile beyond it, if both are as far along the side and as high. In double precision and in
// parallel; the same bits for any number of threads. About 0.2 us per vertex.
Mesh covered_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                   const Covering& covering, const CoveringPose& pose,
                   std::span<const std::uint32_t> tiles);
Mesh covered_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                   const Covering& covering, const CoveringPose& pose); // of all

// HeightsOverUvs are heights by a picture over the texture coordinates of the base.
struct HeightsOverUvs {
    const GreyImage& image;
    const HeightSheet& sheet;
    const ChartUvs& uvs; // of the covering's charts
    const ChartNet& net;
    // The surface itself over the charts, in the world; of any thread.
    std::function<SurfacePoint(const ChartPlace&)> surface;
};
// Makes the tiles of a sheet of heights: its points stand as high as the picture is bright where
// they lie on the base. Conventional displacement, P + h(u, v) N with P and N of the surface
// itself. Where coordinates have a seam the heights have one, too. Even heights have the normals N,
// and others lean from that. Without tangents.
Mesh displaced_tiles(const Mesh& mesh, const glm::dmat4& to_model, const CoverCell& cell,
                     const Covering& covering, const CoveringPose& pose,
                     std::span<const std::uint32_t> tiles, const HeightsOverUvs& heights);

// The matrix from a cell to the unit cell of core/patches/tile_set.h, for patched_tile().
glm::dmat4 to_unit_cell(const CoverCell& cell);

// A PatchedTile is a tile of a covering as a single patch under the whole tile, which the graphics
// card can repeat.
struct PatchedTile {
    PlacedTile tile;
    // The distance from the tile of covered_tiles() at nine points, as a share of the tile's
    // length. 0 up to rounding if the tile lies on one cell and its corners are as high.
    double off = 0;
    std::vector<std::uint32_t> cells = {}; // on which it lies
};
// The patch through 16 points of a tile's cells. `cell` must not be turned. About 10 microseconds.
PatchedTile patched_tile(const CoverCell& cell, const Covering& covering, const CoveringPose& pose,
                         std::uint32_t tile);

// The patch of a cell in the world with its outside up, for core/tiles/fold_limit.h.
TilePatch upright_patch(const Covering& covering, std::uint32_t cell, const CoveringPose& pose);

} // namespace trivar
