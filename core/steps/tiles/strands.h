// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/stages/tiled_base.h"
#include "core/steps/tiles/tile_kinds.h"
#include "core/tiles/layout.h"
#include "core/tiles/strand_chart.h"
#include "core/tiles/tile_counts.h"

namespace trivar {

// A StrandInput is the input for the strands of a layer.
struct StrandInput {
    const Tiling& tiling;
    const TileKinds& kinds; // of its tiles
    const Ref<TileBase>& base;
    const Ref<TileLayout>& layout; // before tiles have slid
    const TiledPieces& pieces;
    const FoundLimit& limit;
    const std::map<int, std::vector<Part>>& members; // of the base
    Timings& timings;
};
struct StrandParts {
    std::vector<Part> parts; // in the world
    TileCounts counts;
    std::vector<std::string> notices;
    // The greatest height of each stroke's tiles as a share of the proven limit; 0: not asked.
    std::vector<double> of_limit;
};

// Strands lays tiles end to end along the strands of a layout. Where their nodes are on the base at
// rest is found again only when the layout or the width of the tiles changes. Tiles are TileSets,
// whose meshes meet to the last bit; the guard lowers what tiles have in common, so that they still
// meet.
class Strands {
public:
    StrandParts operator()(const StrandInput& input);

private:
    using Charts = std::vector<StationChart>;
    struct ChartInput {
        Ref<TileBase> base;
        Ref<LimitBase> limit; // null: the charts lie on the triangles of the base
        Ref<TileLayout> layout;
        double width;
        bool operator==(const ChartInput&) const = default;
    };
    struct Model {
        Ref<TileModel> tile;
        int unmatched = 0;
    };
    Ref<Charts> charts(const StrandInput& input, double width);
    // The tile of one of the kind's parts; `unit` takes the kind to the unit cell.
    Model model(const TileKind& kind, const Part& part, const glm::dmat4& unit);

    Kept<ChartInput, Ref<Charts>> charts_;
    Kept<UnitTile, Model> models_{64};
};

// A StrandPlace is how an object becomes the tile of strands: `turn` about the strand, then a unit
// cell along x with the path in the middle of y. Lengths are metres.
struct StrandPlace {
    glm::dmat4 turn{1};
    glm::dvec3 origin{0}; // of the unit cell: where the strand enters it, on the base
    double length = 1, half_width = 0.5;
    double top = 1; // in lengths; of the higher one of even and odd tiles
};
// Gives the places of the tiles of an object: that of every tile, or those of even and odd ones.
std::vector<StrandPlace> strand_places(const TileKind& kind, const TileLook& look);

} // namespace trivar
