// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/scene_view.h"

#include "ui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {

const std::array<Viewpoint, 6>& viewpoints()
{
    static const std::array<Viewpoint, 6> all{{{"Front", {0, -1, 0}},
                                               {"Right", {1, 0, 0}},
                                               {"Top", {0, 0, 1}},
                                               {"Back", {0, 1, 0}},
                                               {"Left", {-1, 0, 0}},
                                               {"Bottom", {0, 0, -1}}}};
    return all;
}

const Viewpoint* viewpoint_of(const Camera& camera)
{
    const glm::dvec3 from = glm::normalize(camera.eye - camera.target);
    const auto seen = [&](const Viewpoint& side) {
        return glm::dot(side.from, from) > std::cos(glm::radians(1.0));
    };
    const auto side = std::ranges::find_if(viewpoints(), seen);
    return side == viewpoints().end() ? nullptr : &*side;
}

void SceneView::look_from(const glm::dvec3& direction)
{
    flat_till_turned = flat_till_turned || camera.perspective;
    camera = ui::with_perspective(ui::seen_from(camera, direction), false);
}

void SceneView::turned()
{
    if (std::exchange(flat_till_turned, false)) camera = ui::with_perspective(camera, true);
}

} // namespace trivar
