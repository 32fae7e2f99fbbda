// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/kept.h"
#include "core/stages/step.h"
#include "core/stages/tiled_base.h"
#include "core/tiles/layout.h"
#include "core/tiles/tile_masks.h"

namespace trivar {

// BaseMasks are the masks of a layer with what they read of its base.
struct BaseMasks {
    Ref<TileMasks> masks;   // null: there are none that do anything
    Ref<TileBase> textured; // the meshes of the base with their texture coordinates; null: not read
    bool operator==(const BaseMasks&) const = default;

    bool drive(MaskDrives what) const { return masks && masks->drive(what); }
    // The factors at places of the base at rest, in the space of its model. In parallel; two rays
    // each where texture coordinates are read.
    std::vector<MaskFactors> at(std::span<const SurfacePoint> places) const;
};
struct FoundMasks {
    BaseMasks on_base;
    // Sentences on what is missing for its masks: an image, a curve that was deleted.
    std::vector<std::string> notices, lacks;
    bool operator==(const FoundMasks&) const = default;
};

// A MasksOf finds the masks of a layer; it keeps the last few. Images are read once. A curve is
// taken to the space of the base's model by the base's transform.
class MasksOf {
public:
    FoundMasks operator()(const TiledPieces& pieces, const StepInput& input);
    // The factors of the tiles of a layout, and the layout with their sizes; its strands have
    // what masks make of them in themselves.
    struct MaskedLayout {
        Ref<TileLayout> layout;
        Ref<std::vector<MaskFactors>> factors; // #tiles; null: all are 1
    };
    MaskedLayout masked(const Ref<TileBase>& base, const Ref<TileLayout>& layout,
                        const BaseMasks& masks);

private:
    struct LineInput {
        Ref<EvaluatedObject> curve;
        glm::dmat4 to_world; // of the base
        bool operator==(const LineInput&) const = default;
    };
    struct LayoutInput {
        Ref<TileBase> base;
        Ref<TileLayout> layout;
        BaseMasks masks;
        bool operator==(const LayoutInput&) const = default;
    };
    Kept<LineInput, Ref<LineDistance>> lines_{16};
    Kept<TileMasks, Ref<TileMasks>> masks_;
    Kept<std::vector<TileBase::Piece>, Ref<TileBase>> textured_;
    Kept<LayoutInput, MaskedLayout> layouts_;
};

} // namespace trivar
