// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/patches/tile_patch.h"

#include <vector>

namespace trivar::testing {

// Maps of a surface over its texture square, through which tiles are bent where every tile is a
// cell of the square: the way from which covers by texture differ. They are kept to compare with.
struct SurfaceMaps {
    int size = 0;                      // texels along each side; texel (i, j) is at size j + i
    std::vector<glm::dvec3> p, normal; // at the centre of each texel
    std::vector<glm::dvec3> along_u, along_v; // derivatives of p, over the width of the square
    std::vector<char> inside;                 // whether its centre is on the surface
};

// Only of the first square. Of several triangles over a centre the last one counts.
SurfaceMaps surface_maps(const Mesh& mesh, int size);

// The texel inside that is nearest to each texel, by jump flooding: steps of 1, then of the largest
// power of two below the size, and halves of that down to 1 [1]. -1: there is none. It may be
// another texel than the nearest one, a little farther away. O(#texels log size).
//   [1] Rong, Tan, "Jump flooding in GPU with applications to Voronoi diagram and distance
//       transform", 2006; the first step is that of 1+JFA
std::vector<int> flooded(const std::vector<char>& inside, int size);

enum class Extension { nearest, first_order };
// The maps beyond the charts: the value of the nearest texel inside, or continued from there along
// its derivatives. O(#texels log size).
SurfaceMaps extended(const SurfaceMaps& maps, Extension how);

// Shares of the texels of each cell that are inside, cells being columns by columns.
std::vector<double> valid_shares(const SurfaceMaps& maps, int columns);

// The patch through the maps, bilinear between texels, over a cell.
TilePatch cell_patch(const SurfaceMaps& maps, int columns, int i, int j);

} // namespace trivar::testing
