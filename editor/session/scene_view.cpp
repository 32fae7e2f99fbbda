// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/scene_view.h"

#include "ui/camera_control.h"

#include <utility>

namespace trivar {

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
