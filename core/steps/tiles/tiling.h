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
    struct SlideKey {
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        double turn_deg, scale, slide_x, slide_y, slide_along;
        bool operator==(const SlideKey&) const = default;
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
    struct OutlineKey {
        double turn_deg, scale;
        Ref<std::vector<MaskFactors>> factors;
        std::vector<glm::dvec2> halves; // of the kinds
        std::vector<double> weights;
        bool operator==(const OutlineKey&) const = default;
    };
    struct Painted { // all null where there are neither strokes nor tiles by texture
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        Ref<TileLayout> unslid; // before its tiles slid
        Ref<TileCharts> charts;
        Ref<TextureLayout> by_texture;         // null: none
        Ref<std::vector<MaskFactors>> factors; // of the masks; null: 1
    };
    struct Counted { // the overlaps of the last tiles
        OutlineKey key;
        Runs<Tile> tiles;
        OverlapCount count;
    };
    Painted painted(const TiledPieces& pieces, const FoundLimit& limit, const FoundMasks& masks,
                    const StepInput& input);
    OutlineKey outline_key(const Painted& strokes, const LaidKinds& laid,
                           const TileLook& look) const;
    // Returns for each tile whether it overlaps an earlier one that stays.
    Ref<std::vector<char>> left_out(const Painted& strokes, const LaidKinds& laid,
                                    const OutlineKey& key);
    std::size_t count_overlaps(const Painted& strokes, const LaidKinds& laid,
                               const OutlineKey& key);

    // Uncut is the part of a base on which tiles are laid. It stays the same, with all that is
    // laid, while only the base's cuts and its splitting change.
    struct Uncut {
        std::vector<Part> parts;
        Ref<Shape> shape;
        bool operator==(const Uncut&) const = default;
    };
    Recent<Uncut, Ref<EvaluatedObject>> uncut_;
    LimitBases limits_;
    Recent<Pieces, Ref<TileBase>> bases_;
    Recent<std::pair<Ref<TileBase>, Strokes>, Ref<TileLayout>> layouts_;
    Layouter layouter_;
    Recent<Ref<TileBase>, Lazy<TileCurvature>> curvatures_;
    TextureTiles textures_;
    Recent<std::pair<Ref<TileLayout>, Ref<TextureLayout>>, Ref<TileLayout>> joined_;
    Recent<SlideKey, Ref<TileLayout>> slides_;
    PaintedTiles painted_;
    std::vector<Ref<TileSet>> sets_; // the last ones
    Recent<std::pair<Ref<TileLayout>, OutlineKey>, Ref<std::vector<char>>> left_out_;
    std::optional<Counted> counted_;
    TileKindsOf kinds_of_;
    MasksOf masks_of_;
    Covers covers_;
    Strands strands_;
    Recent<Key, Ref<Stage>> shown_;
};

} // namespace trivar
