// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// The pattern in which tiles cover a whole surface.
//
//    grid  [   ][   ][   ]     brick  [   ][   ][   ]     hexagon: bricks that reach a quarter
//          [   ][   ][   ]              [   ][   ][   ]   of their length into the next rows
enum class TilePattern {
    none,    // they do not
    grid,    // rows of tiles, each tile beside that of the next row
    brick,   // every other row is shifted by half a tile
    hexagon, // the same, and tiles reach a quarter of their length into the rows beside theirs
    texture, // one for each cell of the texture square that has its centre on the surface
};

// A TileCover says how the tiles of a layer cover their base, besides those that strokes lay.
struct TileCover {
    TilePattern pattern = TilePattern::none;
    double size = 0.1; // length of a tile along its row, metres on the base's model at rest
    int per_face = 0;  // number of tiles along each side of a face; 0: as `size` says
    double height_variation = 0; // 0..1: heights are smaller by up to that share
    int seed = 1;
    int columns = 20, rows = 20; // of cells, with the pattern `texture`
    bool even_height = false;    // tiles are as high as their object everywhere, in metres
    bool operator==(const TileCover&) const = default;
};

} // namespace trivar
