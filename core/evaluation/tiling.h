// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/covers.h"
#include "core/evaluation/masking.h"
#include "core/evaluation/strands.h"
#include "core/evaluation/texture_tiles.h"
#include "core/tiles/chart.h"
#include "core/tiles/limit_chart.h"

namespace trivar {

// TileCharts say where the tiles of a layout are on their base at rest; one of the lists is empty.
struct TileCharts {
    std::vector<TileChart> flat;    // on the triangles of the base
    std::vector<LimitChart> smooth; // on its limit surface
    std::size_t count() const { return flat.size() + smooth.size(); }
    double cut(std::size_t i) const { return flat.empty() ? smooth[i].cut : flat[i].cut; }
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
        double turn_deg, scale, slide_x, slide_y;
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
    struct Painted { // all null where there are neither strokes nor tiles by texture
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        Ref<TileCharts> charts;
        Ref<TextureLayout> by_texture; // null: none
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

    LimitBases limits_;
    Recent<Pieces, Ref<TileBase>> bases_;
    Recent<std::pair<Ref<TileBase>, Strokes>, Ref<TileLayout>> layouts_;
    TextureTiles textures_;
    Recent<std::pair<Ref<TileLayout>, Ref<TextureLayout>>, Ref<TileLayout>> joined_;
    Recent<SlideKey, Ref<TileLayout>> slides_;
    Recent<ChartKey, Ref<TileCharts>> charts_;
    LastCharts last_;
    TileKindsOf kinds_of_;
    MasksOf masks_of_;
    Covers covers_;
    Strands strands_;
    Recent<Key, Ref<Stage>> shown_;
};

} // namespace trivar
