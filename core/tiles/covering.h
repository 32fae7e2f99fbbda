// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/shared_nodes.h"
#include "core/patches/tile_patch.h"
#include "core/tiles/tile_cover.h"

namespace trivar {

// A Covering cuts every chart of a surface into cells, and lays tiles over them. Each cell is one
// patch, and all that two cells share follows from nodes that they share: where a tile's outline
// lies on a side of a cell, the tile beyond it has its outline there to the last bit.
//
//      3------- edge 2 -------2      a chart with 3 x 2 cells (i along u, j along v) and
//      |  0, 1 |  1, 1 |  2, 1 |      turns 0: rows run along u. Bricks: every other row is
//      |-------+-------+-------|      shifted by half a cell; a tile then spans two cells
//      |  0, 0 |  1, 0 |  2, 0 |
//      0------- edge 0 -------1
class Covering {
public:
    // `tile_size` holds the length of a tile along its row and its width across. Throws Rejected
    // for more than most_tiles cells. O(#charts log #charts + #cells).
    Covering(const ChartSurface& surface, const TileCover& cover, const glm::dvec2& tile_size);

    std::size_t cell_count() const { return cells_.size(); }
    struct Cell {
        std::uint32_t chart;
        int i, j; // along u and v
    };
    const Cell& cell(std::uint32_t id) const { return cells_[id]; }
    const SharedNodes& nodes() const { return nodes_; } // of the cells' patches
    // Evaluates the nodes' points on a surface over the same charts.
    std::vector<SurfacePoint> points(const ChartSurface& surface) const;
    // Gives the four corners of a cell among the nodes, as those of a chart are numbered.
    std::array<std::uint32_t, 4> corners(std::uint32_t cell) const;
    std::array<std::uint32_t, 16> cell_nodes(std::uint32_t cell) const; // as of a TilePatch
    TilePatch patch(std::uint32_t cell, std::span<const SurfacePoint> points) const;
    // Returns the chart coordinates of a place of a cell; 1 - x and 1 - y are exact.
    glm::dvec2 in_chart(std::uint32_t cell, const glm::dvec2& uv) const;
    // Tells by how many quarter turns the cell's row is turned from u.
    int turns(std::uint32_t cell) const { return turns_[cells_[cell].chart]; }

    // An Extent is the part of a cell, or of two, that a tile covers.
    enum class Extent : char {
        whole,    // the whole cell
        spanning, // the second half of a cell and the first half of the next one in the row
        first, // half a tile in the first half of a cell, where the row does not come from beyond
        second // half a tile in the second half of a cell, where the row does not go on
    };
    struct Laid {
        std::uint32_t cell;
        Extent extent = Extent::whole;
        // Set for hexagons whose row before or behind does not continue: the tile ends with its own
        // row.
        bool flat_before = false, flat_behind = false;
    };
    const std::vector<Laid>& tiles() const { return tiles_; }

    // A Spot says where a point of a tile lies: x along its row and y across, both from 0 to 1 in a
    // tile of its own cell alone.
    struct Spot {
        std::uint32_t cell;
        glm::dvec2 uv;    // in the cell, or beyond it where a border stops the way
        int turns = 0;    // quarter turns from the tile's directions to the cell's
        double along = 1; // factor of lengths along x
    };
    Spot spot(const Laid& tile, const glm::dvec2& at) const;

    TilePattern pattern() const { return pattern_; }

private:
    struct Beside {
        std::uint32_t cell = ChartNet::none;
        int side = 0; // by which it is entered
    };
    Beside beside(std::uint32_t cell, int side) const;
    bool row_goes_on(std::uint32_t cell, int side) const;
    std::uint32_t cell_at(std::uint32_t chart, int i, int j) const;
    int row_of(std::uint32_t cell) const;
    void lay();

    TilePattern pattern_;
    ChartNet net_;
    std::vector<int> turns_;
    std::vector<glm::ivec2> counts_;   // of cells
    std::vector<std::uint32_t> first_; // cell of each chart
    std::vector<Cell> cells_;
    SharedNodes nodes_;
    std::vector<Laid> tiles_;
};

// Evaluates a point of a patch as tile_point() does, by sums that are the same to the last bit for
// a line that runs the other way: 1 - t must be exact for x and y.
TilePoint symmetric_tile_point(const TilePatch& patch, const glm::dvec3& p_tile);

// Rounds t to a multiple of 2^-20, of which 1 - t is exact too.
double snapped(double t);

} // namespace trivar
