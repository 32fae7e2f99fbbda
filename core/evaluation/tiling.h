// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/covers.h"
#include "core/evaluation/masking.h"
#include "core/evaluation/strands.h"
#include "core/evaluation/texture_tiles.h"
#include "core/tiles/chart.h"
#include "core/tiles/limit_chart.h"

#include <limits>

namespace trivar {

// TileCharts say where the tiles of a layout are on their base at rest; one of the lists is empty.
struct TileCharts {
    std::vector<TileChart> flat;    // on the triangles of the base
    std::vector<LimitChart> smooth; // on its limit surface
    std::size_t count() const { return flat.size() + smooth.size(); }
    double cut(std::size_t i) const { return flat.empty() ? smooth[i].cut : flat[i].cut; }
};

// LaidKinds say what kind each tile of a layout is of, and what masks make of it.
struct LaidKinds {
    std::vector<std::size_t> kinds;                    // of each tile
    std::vector<TileCell> cells;                       // of each kind
    const std::vector<MaskFactors>* factors = nullptr; // of each tile; null: 1
    bool has(std::size_t i, const Tile& tile) const;   // whether masks leave tile i there
};

// A StandingTile is a painted tile where its base stands at a frame, before it is known how high it
// is to be.
struct StandingTile {
    enum class Fate : char { there, at_border, not_there, overlapping } fate = Fate::there;
    TilePatch patch;
    double side = 0; // metres in the world
    // up to which it is proven not to fold, metres in the world; 0: it folds in itself
    double limit = std::numeric_limits<double>::infinity();
};

// A TilingStep puts copies of an object's meshes where its strokes lay them on their base, and all
// over it where they cover it, as the base stands at a frame. The strokes are worked off on the
// base at rest, and again only when one of them or the base's meshes changed; where the base moves,
// the patches alone follow it.
class TilingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    using Pieces = std::vector<TileBase::Piece>;
    using Strokes = std::vector<Ref<TileStroke>>;
    struct SlideKey {
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        double turn_deg, scale, slide_x, slide_y, slide_along;
        bool operator==(const SlideKey&) const = default;
    };
    struct ChartKey {
        Ref<TileLayout> layout;
        double turn_deg, scale;
        bool operator==(const ChartKey&) const = default;
    };
    struct Key {
        Ref<Stage> before;
        Ref<EvaluatedObject> base;
        Ref<TileCharts> charts;
        TileLook look;
        TileCover cover;
        TileKinds kinds;
        FoundMasks masks;
        bool operator==(const Key&) const = default;
    };
    struct StandingKey {
        Ref<EvaluatedObject> base;
        Ref<TileCharts> charts;
        Ref<std::vector<char>> overlapping;
        Ref<std::vector<MaskFactors>> factors;
        std::vector<double> reaches, weights; // of the kinds
        double growth, growth_softness;
        bool guard;
        bool operator==(const StandingKey&) const = default;
    };
    struct OverlapKey {
        Ref<TileLayout> layout;
        double turn_deg, scale;
        bool left_out;
        Ref<std::vector<MaskFactors>> factors;
        std::vector<glm::dvec2> halves; // of the kinds
        std::vector<double> weights;
        bool operator==(const OverlapKey&) const = default;
    };
    using Members = std::map<int, std::vector<StandingTile>>; // by member of the base
    struct Painted { // all null where there are neither strokes nor tiles by texture
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        Ref<TileLayout> unslid; // before its tiles slid
        Ref<TileCharts> charts;
        Ref<TextureLayout> by_texture;         // null: none
        Ref<std::vector<MaskFactors>> factors; // of the masks; null: 1
    };
    struct LastCharts { // of which those of tiles that stay are taken over
        Ref<TileBase> base;
        double turn_deg = 0, scale = 0;
        Ref<TileLayout> layout;
        Ref<TileCharts> charts;
    };
    Ref<TileCharts> charts(const FoundLimit& limit, const Ref<TileBase>& base,
                           const Ref<TileLayout>& layout, const TileLook& look, Timings& timings);
    Painted painted(const TiledPieces& pieces, const FoundLimit& limit, const FoundMasks& masks,
                    const StepInput& input);
    // Of each tile whether it overlaps another one, or where such are left out, an earlier one.
    Ref<std::vector<char>> overlaps(const Painted& strokes, const TileKinds& kinds,
                                    const LaidKinds& laid, const TileLook& look, Timings& timings);

    LimitBases limits_;
    Recent<Pieces, Ref<TileBase>> bases_;
    Recent<std::pair<Ref<TileBase>, Strokes>, Ref<TileLayout>> layouts_;
    Recent<Ref<TileBase>, Lazy<TileCurvature>> curvatures_;
    TextureTiles textures_;
    Recent<std::pair<Ref<TileLayout>, Ref<TextureLayout>>, Ref<TileLayout>> joined_;
    Recent<SlideKey, Ref<TileLayout>> slides_;
    Recent<ChartKey, Ref<TileCharts>> charts_;
    LastCharts last_;
    Recent<OverlapKey, Ref<std::vector<char>>> overlaps_;
    Recent<StandingKey, Ref<Members>> standing_{1}; // 800 bytes per tile
    TileKindsOf kinds_of_;
    MasksOf masks_of_;
    Covers covers_;
    Strands strands_;
    Recent<Key, Ref<Stage>> shown_;
};

} // namespace trivar
