// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/placement/shaper.h"
#include "core/stages/bending.h"
#include "core/stages/step.h"
#include "core/steps/laying/ground_plane.h"
#include "core/steps/laying/stroke_motions.h"

namespace trivar {

// LayingStep lays an object along its stroke, or round a closed surface, while its stroke, its
// parameters or the scene change. It keeps the scene for rays and the sorting of the meshes into
// the volume, too. Stages: rays, springs, lift and volume, as place() names them, shape, and deform
// for the objects on which it lies.
class LayingStep : public Step {
public:
    explicit LayingStep(std::shared_ptr<StrokeMotions> stroke_motions)
        : stroke_motions_(std::move(stroke_motions))
    {
    }
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    struct Stroke { // what is laid, and on what
        Ref<Stage> before;
        glm::dmat3 turned;                 // the object's own rotation and scale, before it is laid
        std::optional<glm::dvec3> lattice; // size of its box, where a lattice is laid
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

    std::shared_ptr<StrokeMotions> stroke_motions_;
    GroundPlane ground_;
    Recent<Stroke, Landing> fallen_;
    Recent<ShapedStroke, Ref<Stage>> laid_;
    Recent<std::vector<Support>, Ref<RayScene>> scenes_{1};
    Shaper shaper_;
    Bending bending_;
};

} // namespace trivar
