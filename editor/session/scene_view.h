// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/followed_view.h"

#include <array>
#include <optional>

namespace trivar {

// A Viewpoint is one of the six directions along axes from which a scene is looked at, and its
// name.
struct Viewpoint {
    const char* name;
    glm::dvec3 from; // unit
};
// Front, Right and Top, then their opposites in the same order.
const std::array<Viewpoint, 6>& viewpoints();
// The side from which a camera looks, up to one degree; null: none.
const Viewpoint* viewpoint_of(const Camera& camera);

// A SceneView is the person's view of the scene; it is no part of the document and of no undo step.
struct SceneView {
    Camera camera;
    bool frame_all_when_evaluated = false;
    std::optional<Camera> go_to; // taken up by the next frame, which knows its size
    std::optional<FollowedView> follows;
    glm::dvec2 picture_px{0};      // of pictures through the render camera; 0: not known yet
    double foot_px = 0;            // of the picture, which cards at its foot cover
    bool flat_till_turned = false; // it looks along an axis and is orthographic for that alone

    // Along an axis, from there: orthographic, until it is turned.
    void look_from(const glm::dvec3& direction);
    // Must follow a turn of the view; one that was flat for its axis alone gets perspective again.
    void turned();
};

} // namespace trivar
