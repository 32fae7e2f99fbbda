// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/runs.h"
#include "core/patches/tile_patch.h"

namespace trivar {

// A PlacedTile is a patch with the factor of z: metres in the world per unit of the tile's height.
// A point of the tile in its unit cell, z in sides, lies at T(x, y, height z + base).
struct PlacedTile {
    TilePatch patch;
    double height = 1;   // metres in the world of what is one side high
    double base = 0;     // added to z, metres in the world
    glm::vec3 tint{1};   // factor of the colours of its material, linear
    float tint_over = 0; // share by which the tint takes the place of the colours of its vertices
    // The height that it was to have, as a share of that up to which it is proven not to fold;
    // above 1 it was lowered. 0: nobody asked.
    float of_limit = 0;
    bool operator==(const PlacedTile&) const = default;
};

// The tiles of a layer, in runs; runs that did not change are shared with the former value.
using PlacedTiles = Runs<PlacedTile>;

inline bool is_tinted(const PlacedTile& tile)
{
    return tile.tint != glm::vec3(1) || tile.tint_over != 0;
}

// TilePowers are a placed tile as polynomials in x and y, made for single precision: with
// P'(x, y) = P + base N and N'(x, y) = height N,
//
//   T(x, y, z) = origin + scale (sum_ij c[k][4 j + i] x^i y^j + z sum_ij c[3 + k][4 j + i] x^i y^j)
//
// for the components k. The origin is a corner of the tile, so that coefficients are as small as
// the tile is and differences keep their digits wherever it stands; the scale is a power of two
// that makes them about 1. The derivatives of T, and so the normals, need no more than these.
struct TilePowers {
    std::array<std::array<float, 16>, 6> c{};
    glm::dvec3 origin{0};
    float scale = 1;
};
// Converts in double precision. About 0.3 microseconds.
TilePowers powers_of(const PlacedTile& tile);

// Bounds the points of the tile that come from points of `unit`, a box in the unit cell, by the
// hull of the control points over its x and y. In the world, metres. About a microsecond.
Box hull_box(const PlacedTile& tile, const Box& unit);

// Bounds how many times longer than in the unit cell any way in the tile is. About a microsecond.
double stretch_bound(const PlacedTile& tile, const Box& unit);

} // namespace trivar
