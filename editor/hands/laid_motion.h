// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/placement/place.h"
#include "core/placement/sliding.h"
#include "editor/hands/motion.h"
#include "editor/session/session.h"

#include <optional>

namespace trivar {

// A LaidStand is the state of an object on a stroke when a gesture begins. Places and lengths are
// those of the space of its stroke.
struct LaidStand {
    Id object = 0;
    PlacementStep step; // with its stroke as that is now
    Ref<RayScene> scene;
    std::optional<Attachment> hosts = {}; // as they stand there
    glm::dmat4 to_world{1};
    Ground ground = {};        // under the middle of the model
    glm::dvec3 along{1, 0, 0}; // the stroke's direction there, unit
    double width = 0, height = 0;
    double reach = 1; // of the disc over which a normal of the scene is the mean

    // About the middle; along the stroke, to its left, and away from the surface. In the world.
    MotionFrame frame() const;
    // The same as an object's own, for a gesture.
    Stand stand() const;
};

// Returns the stand of the selected object, if it is the only one and its stroke lies on something;
// else nothing.
std::optional<LaidStand> laid_stand(const Session& session);

// The command for a motion with the axes of `of`: its offset slides the stroke over the surface,
// where the third of its own axes lifts it off; it turns about the surface's normal; the factors
// are of length, width and height. Nothing: no scene is there.
std::optional<EditPlacement> moved(const LaidStand& laid, const Motion& motion,
                                   const MotionFrame& of);

// The same for a hand that is free to go anywhere: the middle goes to where the ray through the
// moved pivot meets the scene.
std::optional<EditPlacement> moved_under(const LaidStand& laid, const glm::dvec3& pivot_world,
                                         const Camera& camera);

} // namespace trivar
