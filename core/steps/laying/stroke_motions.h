// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/stages/step.h"
#include "core/steps/laying/ground_plane.h"
#include "core/steps/laying/mesh_anchor.h"

namespace trivar {

// Transforms a part into the space of the stroke by `own_to_drawn`. `part` is in the world of the
// stroke.
Support support_of(const EvaluatedObject& object, Part part, const glm::dmat4& own_to_drawn);

// Finds out how an attached stroke is carried, from where its hosts are and where they were when it
// was drawn. Where they turned, grew evenly or moved as one, that is their motion, to the bits of
// the matrices; else it is the nearest motion of the places under the stroke, and each sample goes
// to where its place is. Shoots no rays. O(number of samples); where a host is posed or bent, its
// mesh is searched once for the samples' places.
class StrokeMotions {
public:
    // Null: the object is attached to nothing that is left. Equal input gives the same pointer, as
    // for a Step.
    Ref<StrokeMotion> operator()(const StepInput& input);

private:
    struct From {
        PlacementStep step;
        std::vector<Ref<EvaluatedObject>> hosts, others; // null where one is not there
        bool operator==(const From&) const = default;
    };
    MeshAnchors anchors_;
    GroundPlane ground_;
    Recent<From, Ref<StrokeMotion>> known_;
};

} // namespace trivar
