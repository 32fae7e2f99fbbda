// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/base/ref_pool.h"
#include "core/split/split.h"
#include "core/stages/step.h"

namespace trivar {

// SplitPartMemory keeps the memory that the splitting of a part uses again at the next frame.
struct SplitPartMemory {
    SplitMemory split;
    RefPool<Mesh> made; // results
    Ref<Mesh> of;       // null: none yet
    Mesh in_world;      // that mesh in the world at the last frame, with points
    bool mirrored = false;
};

// SplittingStep parts an object round its obstacles, as both stand at the frame. An obstacle that
// moves without turning keeps its field. Stage: split.
class SplittingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    // A Body is one source of a field: a body of an obstacle, relative to the frame's origin.
    struct Body {
        Ref<RayMesh> mesh;
        glm::dmat4 to_origin{1};
        std::size_t obstacle = 0;
        bool operator==(const Body&) const = default;
    };
    struct FieldKey {
        std::vector<Body> bodies;
        Splitting splitting;
        bool operator==(const FieldKey&) const = default;
    };
    struct StageKey {
        Ref<Stage> before;
        Ref<SplitField> field;
        glm::dvec3 origin{0};
        Splitting splitting;
        bool filled = false; // its material fills it with a pattern
        bool operator==(const StageKey&) const = default;
    };
    Recent<FieldKey, Ref<SplitField>> fields_;
    Recent<StageKey, Ref<Stage>> known_;
    std::vector<SplitPartMemory> memory_; // by part
};

} // namespace trivar
