// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/steps/tiles/covers.h"
#include "core/steps/tiles/masking.h"
#include "core/steps/tiles/painted_tiles.h"
#include "core/steps/tiles/strands.h"
#include "core/steps/tiles/texture_tiles.h"
#include "core/tiles/layouter.h"
#include "core/tiles/overlaps.h"

#include <optional>

namespace trivar {

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
    using Members = std::map<int, std::vector<Part>>;
    // Uncut is a base as its tiles see it. While only its cuts and its splitting change, the first
    // one that was seen stays, with all that is laid.
    struct Uncut {
        Ref<EvaluatedObject> base;
        std::vector<Part> parts; // all of it
        bool operator==(const Uncut& other) const
        {
            return parts == other.parts && base->shape == other.base->shape;
        }
    };
    struct Ground { // of painted tiles
        Ref<TileBase> base;
        Ref<LimitBase> limit; // whose triangles are those of the base; null: those of its meshes
        bool operator==(const Ground&) const = default;
    };
    struct LayoutInput {
        Ground on;
        Strokes strokes;
        bool operator==(const LayoutInput&) const = default;
    };
    struct SlideInput {
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        TileLook way; // turn, scale and slides alone
        bool operator==(const SlideInput&) const = default;
    };
    struct Outlines { // of painted tiles
        Ref<TileBase> base;
        LaidKinds laid;
        double turn_deg, scale;
        std::vector<glm::dvec2> halves; // of the kinds
        bool operator==(const Outlines&) const = default;
        // Returns those of the tiles from a number on.
        std::vector<TileOutline> of(const Runs<Tile>& tiles, std::size_t from) const;
    };
    struct OverlapInput {
        Ref<TileLayout> layout;
        Outlines outlines;
        bool operator==(const OverlapInput&) const = default;
    };
    struct Counted { // the overlaps of the last tiles
        Outlines outlines;
        Runs<Tile> tiles;
        OverlapCount count;
    };
    struct Painted { // all null where there are neither strokes nor tiles by texture
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        Ref<TileLayout> unslid; // before its tiles slid
        Ref<TileCharts> charts;
        Ref<TextureLayout> by_texture;         // null: none
        Ref<std::vector<MaskFactors>> factors; // of the masks; null: 1
        bool operator==(const Painted&) const = default;
    };
    struct ShownInput {
        Ref<Stage> before;
        Ref<EvaluatedObject> base;
        TiledPieces pieces;
        FoundLimit limit;
        FoundMasks masks;
        Painted strokes;
        TileKinds kinds;
        Tiling tiling;
        bool operator==(const ShownInput&) const = default;
    };
    Painted painted(const ShownInput& shown, const StepInput& input);
    Ref<TileLayout> slid(const Ref<TileBase>& base, const Ref<TileLayout>& layout,
                         const TileLook& look);
    Ref<Stage> shown(const ShownInput& in, Timings& timings);
    // Returns why the tiles of strokes cannot be shown; empty: they are in the stage.
    std::string add_painted(Stage& stage, const ShownInput& in, const Members& members,
                            TileCounts& told, Timings& timings);
    void add_sets(Stage& stage, const ShownInput& in, const std::vector<TileCell>& cells,
                  std::vector<PlacedTiles> of_kinds, Timings& timings);
    std::size_t count_overlaps(const Runs<Tile>& tiles, const Outlines& outlines);

    Kept<Uncut, Ref<EvaluatedObject>> uncut_;
    LimitBases limits_;
    Kept<Pieces, Ref<TileBase>> bases_;
    Kept<LayoutInput, Ref<TileLayout>> layouts_;
    Layouter layouter_;
    Kept<Ground, Lazy<TileCurvature>> curvatures_;
    TextureTiles textures_;
    Kept<std::pair<Ref<TileLayout>, Ref<TextureLayout>>, Ref<TileLayout>> joined_;
    Kept<SlideInput, Ref<TileLayout>> slides_;
    PaintedTiles painted_;
    std::vector<Ref<TileSet>> sets_;                      // the last ones
    Kept<OverlapInput, Ref<std::vector<char>>> left_out_; // of each tile, whether it overlaps
    std::optional<Counted> counted_;
    TileKindsOf kinds_of_;
    MasksOf masks_of_;
    Covers covers_;
    Strands strands_;
    Kept<ShownInput, Ref<Stage>> shown_;
};

} // namespace trivar
