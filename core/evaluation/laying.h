// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/bending.h"
#include "core/evaluation/step.h"

namespace trivar {

// What a stroke sees: the parts of the objects it may fall on.
struct Support {
    Id id = 0;
    Part part;
    bool operator==(const Support&) const = default;
};

// Lays an object along its stroke, or round what it goes round, while its stroke, its parameters or
// the scene change; keeps the scene for rays and how the meshes are sorted into the volume, too.
// Stages: rays, springs, lift and volume, as place() names them, shape, and deform for what it lies
// on.
class Laying : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    struct Stroke { // what is laid, and on what
        Ref<Stage> before;
        glm::dmat3 turned; // the object's own turn and size, before it is laid
        PlacementStep step;
        std::vector<Support> supports;
        bool operator==(const Stroke&) const = default;
    };
    struct Landing {
        Ref<Placement> placement; // null: rejected
        Ref<RayScene> scene;
        std::string rejected;
    };
    struct ShapedStroke {
        Stroke stroke;
        std::vector<Ref<VolumeEdit>> shaping;
        bool operator==(const ShapedStroke&) const = default;
    };
    Ref<Stage> laid_on(Stroke stroke, const StepInput& input);
    Landing fall(const Stroke& stroke, const StepInput& input);
    Ref<RayScene> scene_of(const std::vector<Support>& supports, const StepInput& input);
    void bend(Stage& stage, const glm::dmat3& turned);

    Recent<Stroke, Landing> fallen_;
    Recent<ShapedStroke, Ref<Stage>> laid_;
    Recent<std::vector<Support>, Ref<RayScene>> scenes_{1};
    Shaper shaper_;
    Bending bending_;
};

} // namespace trivar
