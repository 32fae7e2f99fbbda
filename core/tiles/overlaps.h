// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/near_tiles.h"

#include <span>
#include <utility>

namespace trivar {

// A TileOutline is the rectangle that a tile covers in the plane of its normal, on the base at
// rest: along its x axis and across, about its middle.
struct TileOutline {
    glm::dvec3 p{0}, x{1, 0, 0}, n{0, 0, 1}; // metres on the model; unit
    glm::dvec2 half{0};                      // of its length and width, metres; 0: it is not there
};

// The depth of the overlap of two outlines, metres: how far one must go at least so that they do
// not overlap; 0 where they do not, or lie on different sides of a sheet.
double overlap_depth(const TileOutline& a, const TileOutline& b);

// Two tiles overlap where the depth is more than this share of the lesser of their longer sides.
inline constexpr double overlap_share = 0.1;

// Tells of each tile whether it overlaps another one. In parallel; about a microsecond per tile.
std::vector<char> overlapping(std::span<const TileOutline> tiles);

// An OverlapCount counts the tiles that overlap another one, of a list whose end changes.
class OverlapCount {
public:
    // `usual`: tiles that are about as large as those to come; for the grid in which they are
    // found.
    explicit OverlapCount(std::span<const TileOutline> usual);
    // Adds tiles. In parallel; about a microsecond per tile.
    void add(std::span<const TileOutline> tiles);
    void keep(std::size_t count); // forgets the tiles behind the first ones
    std::size_t size() const { return tiles_.size(); }
    std::size_t overlapping() const { return overlapping_; }
    bool overlaps(std::size_t tile) const { return pairs_of_[tile] > 0; }

private:
    std::vector<TileOutline> tiles_;
    NearTiles near_;                                         // those that are there
    std::vector<int> pairs_of_;                              // #tiles
    std::vector<std::pair<std::size_t, std::size_t>> pairs_; // the later one first, ascending
    std::size_t overlapping_ = 0;
    double largest_ = 0; // of all that were ever there
};

// Tells of each tile whether it overlaps an earlier one that stays: without all of these no tile
// overlaps another. About 2 microseconds per tile.
std::vector<char> overlapping_earlier(std::span<const TileOutline> tiles);

} // namespace trivar
