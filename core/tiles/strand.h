// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/strand_path.h"
#include "core/tiles/tile_stroke.h"

#include <array>
#include <cstdint>

namespace trivar {

// A StrandStation is a place of a strand's path; cells that meet there share it.
struct StrandStation {
    SurfacePlace at;
    glm::dvec3 x{1, 0, 0}; // unit, the direction of the path in the plane of the normal
    double width = 0;      // of a tile as wide as long, metres on the model
    double height = 1;     // factor
    bool operator==(const StrandStation&) const = default;
};

// A StrandCell is the place of one tile of a strand.
struct StrandCell {
    std::array<std::uint32_t, 4> stations{}; // at 0, 1/4, 3/4 and 1 of its length
    int before = -1, behind = -1;            // the cells that share its ends; -1: none
    double length = 0;                       // of its path, metres on the model
    std::uint32_t seed = 0;
    int number = 0;                // along the strand, by which tiles alternate
    int stroke = 0;                // number of the stroke that laid it
    double begin_s = 0, end_s = 0; // when the stroke came to its two ends
    bool gone = false;             // erased, or a mask leaves it out
    glm::dvec3 tint{1};            // factor of the colours of its material, linear
    double morph = 0;              // -1..1, added to that of its layer
    double morph_factor = 1;       // of the morph of its layer, by masks
    bool operator==(const StrandCell&) const = default;
};

struct StrandLayout {
    std::vector<StrandStation> stations;
    std::vector<StrandCell> cells;
    int too_short = 0;     // number of strokes that are too short for a tile
    bool too_many = false; // there would be more than most_tiles
    bool operator==(const StrandLayout&) const = default;
};

// Adds the strand of a stroke. Its path is a curve through the samples, smoothed over a third of
// `stroke.size` and laid back onto the surface; it is divided into cells of equal length, near that
// size. Ends within three quarters of a size of the open end of another strand take over its
// station and go on from it; a path whose ends are as near to each other closes, with an even
// number of cells.
//   number  of the stroke
//   points  its samples on the surface, space of the model
// About 2 us for each twelfth of a cell.
void add_strand(StrandLayout& layout, const TileBase& base, const TileStroke& stroke, int number,
                std::vector<StrandPoint> points);

// Lets a stroke of erase, resize, raise, color or morph change the strands under its brush.
void change_strands(StrandLayout& layout, const TileBase& base, const TileStroke& stroke,
                    const std::vector<StrandPoint>& points);

} // namespace trivar
