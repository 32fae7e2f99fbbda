// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/stages/tiled_base.h"
#include "core/steps/tiles/per_run.h"
#include "core/steps/tiles/tile_kinds.h"
#include "core/tiles/chart.h"
#include "core/tiles/layout.h"
#include "core/tiles/limit_chart.h"
#include "core/tiles/tile_counts.h"
#include "core/tiles/tile_masks.h"

#include <limits>

namespace trivar {

// ChartRun says where the tiles of a run are on their base at rest; one of the lists is empty.
struct ChartRun {
    std::vector<TileChart> flat;    // on the triangles of the base
    std::vector<LimitChart> smooth; // on its limit surface
    double cut(std::size_t i) const { return flat.empty() ? smooth[i].cut : flat[i].cut; }
};
using TileCharts = std::vector<Ref<ChartRun>>; // of each run of a layout

// A StandingTile is a painted tile where its base stands at a frame, before it is known how high it
// is to be.
struct StandingTile {
    enum class Fate : char { there, at_border, not_there, overlapping } fate = Fate::there;
    TilePatch patch;
    double side = 0; // metres in the world
    // up to which it is proven not to fold, metres in the world; 0: it folds in itself
    double limit = std::numeric_limits<double>::infinity();
};

// LaidKinds say what kind each tile of a layout is of, and what masks make of it.
struct LaidKinds {
    KindChoice choice;
    Ref<std::vector<MaskFactors>> factors; // of each tile; null: 1
    bool operator==(const LaidKinds&) const = default;
    std::size_t kind(std::size_t i, const Tile& tile) const;
    bool has(std::size_t i, const Tile& tile) const; // whether masks leave tile i there
};

struct PaintedInput {
    const TiledPieces& pieces;
    const FoundLimit& limit;
    const Ref<EvaluatedObject>& shown;               // the base
    const std::map<int, std::vector<Part>>& members; // of it
    const Ref<TileBase>& base;
    const Ref<TileLayout>& layout;
    const Ref<TileCharts>& charts;
    const TileLook& look;
    const LaidKinds& laid;
    const std::vector<TileCell>& cells;     // of each kind
    const Ref<std::vector<char>>& left_out; // of each tile, whether it overlaps; null: none is
    std::size_t strokes;                    // number of them
};

// A PaintedTiles puts the tiles of a layout on their base as it stands, run by run: runs that are
// as they were keep what was computed of them. A dab of a brush costs what it changes.
class PaintedTiles {
public:
    // Returns the charts; while the base's meshes do not change, those of tiles that stay are kept.
    Ref<TileCharts> charts(const FoundLimit& limit, const Ref<TileBase>& base,
                           const Ref<TileLayout>& layout, const TileLook& look);
    struct Placed {
        std::vector<PlacedTiles> of_kinds;
        TileCounts counts;
        // The heights of the look up to which none is lowered, by stroke, and behind them that of
        // tiles of no stroke; infinite: none is.
        std::vector<double> limits;
    };
    Placed operator()(const PaintedInput& input);

private:
    struct ChartFrom {
        Ref<TileBase> base;
        Ref<LimitBase> limit; // null: the charts lie on the triangles of the base
        double turn_deg, scale;
        bool operator==(const ChartFrom&) const = default;
    };
    struct ChartInput {
        ChartFrom from;
        Ref<TileLayout> layout;
        bool operator==(const ChartInput&) const = default;
    };
    struct StandingFrom {
        Ref<EvaluatedObject> shown;
        Ref<TileBase> base;
        Ref<std::vector<char>> left_out;
        LaidKinds laid;
        std::vector<double> reaches; // of the kinds
        double growth, growth_softness, duration_s;
        bool guard;
        bool operator==(const StandingFrom&) const = default;
    };
    struct PlacedFrom {
        Ref<TileBase> base;
        TileLook look;
        LaidKinds laid;
        std::vector<TileCell> cells;
        bool operator==(const PlacedFrom&) const = default;
    };
    using StandingRun = Ref<std::vector<StandingTile>>;
    struct PlacedRun {
        std::vector<PlacedTiles::Run> of_kinds; // null: none
        TileCounts counts;
        std::vector<std::pair<int, double>> limits; // of the strokes that laid them; -1: of none
    };
    struct Member { // of the base
        Ref<EvaluatedObject> shown;
        Ref<TileBase> base;
        std::vector<char> mirrored;    // by part
        std::vector<RestToWorld> ways; // by part
        BasePose pose;                 // empty on a limit surface
        PerRun<StandingFrom, StandingRun> standing;
        PerRun<PlacedFrom, Ref<PlacedRun>> placed;
    };
    Ref<TileCharts> made_charts(const ChartInput& input);
    static StandingTile standing_tile(const Member& member, const PaintedInput& input,
                                      std::size_t run, std::size_t i);
    static StandingRun standing_run(const Member& member, const PaintedInput& input,
                                    std::size_t run);
    static Ref<PlacedRun> placed_run(const PaintedInput& input, std::size_t run,
                                     const std::vector<StandingTile>& standing);

    Kept<ChartInput, Ref<TileCharts>> charts_;
    PerRun<ChartFrom, Ref<ChartRun>> chart_runs_;
    Runs<Tile> charted_; // the last ones
    std::map<int, Member> members_;
};

} // namespace trivar
