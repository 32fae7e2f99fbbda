// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

// Strands on a ball, for tests of what becomes of them.
namespace trivar::testing::strands {

constexpr Id strand_base = 1, strand_tile_id = 2;
constexpr int ribbon_rows = 4, ribbon_columns = 8; // of points: 5 along its ends, 9 along it

// A ball, and a flat piece of ribbon that becomes the tile of a strand on it.
Document with_ribbon();
TileStroke strand_round_the_ball(double from, double to); // radians
Document with_strand(double from = 0, double to = 3);
std::vector<std::string> notices_of(const Document& document); // of the strand

struct StrandCounts {
    std::size_t tiles = 0, points = 0; // points of the same bits are one
};
StrandCounts counted(const Document& document, double frame = 1);
// Number of points of that number of tiles end to end, the ends apart.
std::size_t points_of_open(std::size_t tiles);

} // namespace trivar::testing::strands
