// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace trivar {

// A TilePatch is the piece of a surface that a tile stands on: a bicubic Bezier patch for the
// position and one for the normal, over the unit square. A point (x, y) of the tile, z above its
// base, lies at
//
//   T(x, y, z) = P(x, y) + z N(x, y)                 (Elber, "Geometric texture modeling", 2005)
//
//    \      |        |      /     z = 1: P + N
//     \     |        |     /
//      P----P--------P----P       z = 0: the base; nodes at x = 0, 1/4, 3/4 and 1
//
// Control point 4 j + i belongs to power i of x and j of y.
struct TilePatch {
    std::array<glm::dvec3, 16> p, n;
    bool operator==(const TilePatch&) const = default;
};

// The nodes of a patch stand at these parameters along both axes.
inline constexpr std::array<double, 4> patch_nodes{0, 0.25, 0.75, 1};

// Gives the control points of the bicubic polynomial that has the given values at the nodes, values
// 4 j + i at (nodes[i], nodes[j]).
std::array<glm::dvec3, 16> through_nodes(const std::array<glm::dvec3, 16>& values);

// A TilePoint is a point of a bent tile, with the derivatives of T along x, y and z.
struct TilePoint {
    glm::dvec3 p, x, y, z;
};
// Evaluates in double precision, by the definition; x and y may lie outside the unit square.
TilePoint tile_point(const TilePatch& patch, const glm::dvec3& p_tile);

} // namespace trivar
