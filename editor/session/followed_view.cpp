// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/followed_view.h"

#include "ui/camera_control.h"

namespace trivar {

Camera followed(std::optional<FollowedView>& view, const Document& document, Camera camera,
                glm::dvec2 size_px, glm::dvec2 picture_px)
{
    camera.size_px = glm::max(size_px, 1.0);
    if (!view) return camera;
    if (view->shown) view->shown->size_px = camera.size_px; // a window that grew is no hand
    const auto kept = document.kept_views.find(view->name);
    if (kept == document.kept_views.end() || (view->shown && *view->shown != camera)) {
        view.reset();
        return camera;
    }
    const bool renders = view->name == "picture" && picture_px.x > 0 && picture_px.y > 0;
    const Camera whole = renders ? ui::reshaped(kept->second, picture_px) : kept->second;
    view->shown = ui::reshaped(whole, size_px);
    return *view->shown;
}

} // namespace trivar
