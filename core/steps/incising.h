// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/base/ref_pool.h"
#include "core/incise/flaps.h"
#include "core/incise/incise.h"
#include "core/incise/opened_frames.h"
#include "core/stages/step.h"

namespace trivar {

// IncisingStep cuts the skin of a shape at rest open, before anything poses, lays or bends it. The
// cut depends on strokes, depths and widths; an opening that changes moves vertices only. A stroke
// that goes over several meshes cuts each by its part there. If all incisions are shut, the meshes
// are the former ones. Stage: incise.
class IncisingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

    // A PartOfIncision is the part of an incision that lies on one mesh.
    struct PartOfIncision {
        std::size_t number; // of the incision, the first one is 0
        std::size_t mesh;   // of the shape
        double from, to;    // shares of the stroke's length
        Incision cut;       // the part, on the model

        IncisionOpening opened(IncisionOpening of_all) const
        {
            of_all.from = (of_all.from - from) / (to - from);
            of_all.to = (of_all.to - from) / (to - from);
            return of_all;
        }
    };
    // A Wound is a mesh of the shape that is cut, and the parts of the object's incisions in it.
    struct Wound {
        std::size_t mesh;
        Ref<IncisedMesh> incised;
        std::vector<PartOfIncision> incisions; // by those of `incised`
        std::vector<Incision> cuts;            // the same, in the mesh's space
        double metres;                         // on the model, of a unit of the mesh
        Ref<Extent> rest;                      // of `incised->rest`
    };
    struct Wounds {
        std::vector<Wound> all; // by mesh
        std::vector<IncisingEffects::OfIncision> told;
    };
    // Frames bend the flaps of a wound, and give its mesh at openings and lifts.
    struct Frames {
        Ref<IncisedFlaps> flaps; // null: none
        Ref<OpenedFrames> frames;
    };
    struct OpenMesh {
        Ref<Mesh> mesh;
        Ref<Extent> extent;
    };

private:
    Wounds wounds_in(const Shape& shape, const Incising& incising, const StepInput& input);
    const Frames& frames_of(const Wound& wound, const std::vector<FlapPlace>& places,
                            const StepInput& input);
    Ref<SlitSkin> skin_of(const Ref<Mesh>& mesh, const StepInput& input);

    RefPool<Mesh> made_; // meshes of cuts at rest
    Recent<Ref<Mesh>, Ref<SlitSkin>> skins_;
    Recent<std::pair<Ref<Shape>, Incising>, Ref<Wounds>> wounds_; // all open, of no look
    Recent<std::pair<Ref<IncisedMesh>, std::vector<FlapPlace>>, Frames> frames_;
    struct OpenKey {
        Ref<OpenedFrames> frames;
        std::vector<IncisionOpening> openings;
        std::vector<double> lifts;
        bool operator==(const OpenKey&) const = default;
    };
    Recent<OpenKey, OpenMesh> open_;
    Recent<std::pair<Ref<Stage>, Incising>, Ref<Stage>> known_;
};

} // namespace trivar
