// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/camera_frame.h"

#include "editor/record/record_plan.h"
#include "ui/camera_control.h"

#include <cmath>

namespace trivar {
namespace {

// Returns the height that a picture shows, in units that are the same for all its shapes.
double height_of(const Camera& camera)
{
    return camera.perspective ? std::tan(camera.fov_y / 2) : camera.height_world;
}

} // namespace

ui::Rect picture_frame(const Camera& render_camera, glm::dvec2 size_px, const ui::Rect& view)
{
    const glm::dvec2 seen(view.size());
    const Camera whole = ui::reshaped(render_camera, size_px);
    const double share = height_of(whole) / height_of(ui::reshaped(whole, seen));
    const double half_height = seen.y / 2 * share;
    const glm::vec2 half(half_height * size_px.x / size_px.y, half_height);
    return {view.center() - half, view.center() + half};
}

void draw_camera_frame(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const auto& follows = editor.session.view.follows;
    if (!follows || !follows->shown || follows->name != "picture") return;
    const auto camera = editor.session.document().kept_views.find(follows->name);
    if (camera == editor.session.document().kept_views.end()) return;
    const RecordPlan& plan = editor.memory.of<RecordDialog>().plan;
    const ui::Rect frame = picture_frame(camera->second, {plan.width_px, plan.height_px}, view);
    const ui::Color outside = ui::faded(theme.color.halo, 0.45f);
    ui::paint_box({view.lo, {view.hi.x, frame.lo.y}}, outside);
    ui::paint_box({{view.lo.x, frame.hi.y}, view.hi}, outside);
    ui::paint_box({{view.lo.x, frame.lo.y}, {frame.lo.x, frame.hi.y}}, outside);
    ui::paint_box({{frame.hi.x, frame.lo.y}, {view.hi.x, frame.hi.y}}, outside);
    ui::paint_rim(frame, theme.color.selected, 0, theme.size.hairline);
}

} // namespace trivar
