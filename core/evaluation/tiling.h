// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/tile_kinds.h"
#include "core/tiles/chart.h"

namespace trivar {

// From the mesh of a part of what is painted on to the model of that at rest, in whose space
// strokes of tiles are stored. `object` is the object that the base shows.
glm::dmat4 mesh_to_model(const EvaluatedObject& base, const Object& object, const Part& part);

// A TilingStep puts copies of an object's meshes where its strokes lay them on their base, as the
// base stands at a frame. The strokes are worked off on the base at rest, and again only when one
// of them or the base's meshes changed; where the base moves, the patches alone follow it.
class TilingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    using Pieces = std::vector<TileBase::Piece>;
    using Strokes = std::vector<Ref<TileStroke>>;
    struct ChartKey {
        Ref<TileLayout> layout;
        double turn_deg, scale;
        glm::dvec2 slide;
        bool operator==(const ChartKey&) const = default;
    };
    struct Key {
        Ref<Stage> before;
        Ref<EvaluatedObject> base;
        Ref<std::vector<TileChart>> charts;
        TileLook look;
        TileKinds kinds;
        bool operator==(const Key&) const = default;
    };
    Recent<Pieces, Ref<TileBase>> bases_;
    Recent<std::pair<Ref<TileBase>, Strokes>, Ref<TileLayout>> layouts_;
    Recent<ChartKey, Ref<std::vector<TileChart>>> charts_;
    TileKindsOf kinds_of_;
    Recent<Key, Ref<Stage>> painted_;
};

} // namespace trivar
