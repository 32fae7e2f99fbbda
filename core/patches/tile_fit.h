// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/clip.h"
#include "core/mesh/mesh.h"
#include "core/patches/placed_tile.h"

#include <optional>
#include <vector>

namespace trivar {

// BentPlaces are the vertices of a bent tile in the world, with the sums from which an unbent copy
// of the tile is fitted to them.
struct BentPlaces {
    std::vector<glm::dvec3> places;       // #V, in double precision
    glm::dvec3 unit_middle{0}, middle{0}; // the means of the vertices, in the unit cell and bent
    glm::dmat3 unit_spread{0}, spread{0}; // sums of (u u^T) and (p u^T) about the means, over #V
};
// Bends the vertices of a tile and sums them up.
//   unit      the mesh in the unit cell
//   to_world  applied after the patch
// The derivatives of T in the middle of the tile count a millionth of the vertices, so that
// directions along which the mesh is flat follow them. O(#V), about 0.2 us per vertex.
BentPlaces bent_places(const Mesh& unit, const PlacedTile& tile,
                       const glm::dmat4& to_world = glm::dmat4(1));

// Fits a matrix of the unit cell to the places: the least sum of squares for its nine numbers, and
// the translation that leaves the same distance on both sides of each axis.
glm::dmat4 fitted_matrix(const Mesh& unit, const BentPlaces& to);

// The same for a rotation and a scale along each axis of the unit cell, which take turns (the
// rotation by the polar decomposition of spread times scale; Schoenemann 1966). Empty where the
// tile is mirrored or has no thickness at all.
std::optional<NodeTransform> fitted_parts(const Mesh& unit, const BentPlaces& to);

// Measures how far the furthest vertex is from its place, if a matrix takes it there. The
// distance of all other points of the triangles is at most that.
double furthest(const Mesh& unit, const BentPlaces& from, const glm::dmat4& matrix);

} // namespace trivar
