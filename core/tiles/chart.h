// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/tile_patch.h"
#include "core/tiles/layout.h"

namespace trivar {

// A TileChart says where the nodes of a tile's patch are on the base: the exponential map of its
// middle, by straightest ways. No map of the whole surface is needed, and so no seam cuts a tile.
struct TileChart {
    std::array<SurfacePlace, 16> nodes; // 4 j + i at (patch_nodes[i], patch_nodes[j])
    // Beyond a border: the missing part of the way to the node, in the space of the model.
    std::array<glm::dvec3, 16> beyond{};
    // The longest way that a border cut off, as a share of the tile's size; infinite where the tile
    // is larger than the whole base.
    double cut = 0;
};

// Tiles of which a border cuts off more than this share of their size are left out.
inline constexpr double most_cut = 0.2;

// Lays out the nodes of a tile's patch. `turn_deg` and `scale` come from the layer's look. About 15
// us.
TileChart chart_of(const TileBase& base, const Tile& tile, double turn_deg, double scale);

// A BasePose is where the points of a base are at one moment, with their normals.
struct BasePose {
    std::vector<glm::dvec3> points, normals; // #points of the TileBase
};

// Returns the present position and normal of a place of the base. `beyond` is the part of the way
// to it that a border cut off, in the space of the model; it moves with the triangle.
SurfacePoint posed(const TileBase& base, const BasePose& pose, const SurfacePlace& at,
                   const glm::dvec3& beyond);

// The patch of a tile where the base is now.
TilePatch patch_of(const TileBase& base, const BasePose& pose, const TileChart& chart);

} // namespace trivar
