// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/strand_chart.h"

#include <span>

namespace trivar {

// SlidStrands are strands whose tiles have gone along them.
struct SlidStrands {
    StrandLayout layout;
    std::vector<StrandNodes> nodes;                    // #stations
    std::vector<double> heights;                       // the same
    std::vector<std::array<std::uint32_t, 2>> lies_on; // #cells: of the strands as they were laid
};

// Lets the tiles of strands run along them by a number of cells, where their base is now. `nodes`
// and `heights` are those of the layout's stations. What a tile is (seed, colour, morph, its
// number) goes along; width and height stay where they are. Stations that come to lie inside of a
// cell lie on its patch, so strands stay on their way and welded. Strands that close go round; the
// others stay as long as they are: at an end the tile that leaves fills what is left of its cell,
// as much as is there, and comes in again at the other end. About 5 microseconds per cell.
SlidStrands slid_strands(const StrandLayout& layout, std::span<const StrandNodes> nodes,
                         std::span<const double> heights, double cells);

} // namespace trivar
