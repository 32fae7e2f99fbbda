// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <optional>
#include <vector>

namespace trivar {

// A TextureSpot is a point of a mesh at which the centre of a cell of its texture lies. The texture
// square is cut into columns and rows of cells, and repeats beyond its borders.
struct TextureSpot {
    std::uint32_t triangle = 0;        // of triangles(mesh)
    glm::dvec3 weights{0};             // of its corners, with sum 1
    glm::dvec3 p{0}, normal{0};        // in the model's space
    glm::dvec3 along_u{0}, along_v{0}; // derivatives of p over the size of a cell
    double side = 0;                   // of a square as large as the cell is there
    glm::i64vec2 cell{0};
};

struct TextureSpots {
    std::vector<TextureSpot> spots; // by triangle, row and column
    std::size_t repeated = 0; // spots of cells that an earlier spot has: parts share the texture
    std::size_t flat = 0;     // triangles whose texture coordinates have no area, or no numbers
    bool too_many = false;    // there are more than `most`, and these are the first
};

// Finds every point of a mesh at which its first texture coordinates are those of a cell's centre:
// one per cell, or several where parts of the surface share a piece of the texture. A centre on the
// common edge of two triangles counts once. Triangles without area have none. No value: the mesh
// has no texture coordinates.
//   to_model       the mesh to the space of the spots
//   columns, rows  of cells in the texture square
//   most           greatest number of spots
// O(#triangles + #cells that they cover + #rows of each).
std::optional<TextureSpots> texture_spots(const Mesh& mesh, const glm::dmat4& to_model, int columns,
                                          int rows, std::size_t most);

} // namespace trivar
