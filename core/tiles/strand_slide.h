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

// Lets the tiles of strands run along them, where their base is now. Seed, colour, morph and number
// of a tile go along; width and height stay where they are. Stations that come to lie inside of a
// cell lie on its patch, so strands stay on their way and welded. Strands that close go round; the
// others keep their length: at an end the tile that leaves fills the rest of its cell, and comes in
// again at the other end.
//   nodes, heights  #stations of the layout
//   cells           how far, in cells
// About 5 us per cell.
SlidStrands slid_strands(const StrandLayout& layout, std::span<const StrandNodes> nodes,
                         std::span<const double> heights, double cells);

} // namespace trivar
