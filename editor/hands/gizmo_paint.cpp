// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

void fill(const std::vector<glm::vec2>& area, ui::Color color)
{
    std::vector<ImVec2> points;
    for (const glm::vec2& p : area) points.emplace_back(p.x, p.y);
    ImGui::GetWindowDrawList()->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()),
                                                    color);
}

std::vector<glm::vec2> shifted(std::vector<glm::vec2> points, glm::vec2 by)
{
    for (glm::vec2& p : points) p += by;
    return points;
}

bool is_solid(const HandleShape& shape) // arrow heads and boxes; planes and the middle are glass
{
    return shape.handle.grip == Grip::axis;
}

void paint(const ui::Theme& theme, glm::vec2 at, const HandleShape& shape, bool lit)
{
    const bool white = shape.handle.grip == Grip::center || shape.handle.grip == Grip::view_ring;
    const ui::Color own = white ? theme.color.selected : axis_color(theme, shape.handle.axis);
    const float opacity = lit ? 1 : shape.opacity;
    const ui::Color color = ui::faded(lit ? theme.color.selected : own, opacity);
    const ui::Color halo = ui::faded(theme.color.halo, opacity);
    const float width = theme.line(lit ? 3.0f : shape.closed && !shape.area.empty() ? 1.5f : 2.0f);
    const float around = width + 2 * theme.scale;
    const auto line = shifted(shape.line, at), area = shifted(shape.area, at);
    if (!shape.back.empty())
        ui::paint_path(shifted(shape.back, at), ui::faded(color, 0.25f), theme.line(1.5f));
    ui::paint_path(line, halo, around, shape.closed);
    if (is_solid(shape)) ui::paint_path(area, halo, 2.5f * theme.scale, true);
    if (!area.empty()) fill(area, is_solid(shape) ? color : ui::faded(color, lit ? 0.5f : 0.2f));
    ui::paint_path(line, color, width, shape.closed);
    if (!is_solid(shape)) return;
    constexpr std::array<const char*, 3> names{"X", "Y", "Z"};
    const ui::Rect place = ui::Rect{shape.letter + at, shape.letter + at}.grown(theme.px(10));
    const char* name = names.at(static_cast<std::size_t>(shape.handle.axis));
    const float px = theme.scale;
    for (const glm::vec2 by : {glm::vec2(px, 0),
                               {-px, 0},
                               {0, px},
                               {0, -px},
                               {px, px},
                               {-px, px},
                               {px, -px},
                               {-px, -px}})
        ui::paint_text(theme.font.small_strong, {place.lo + by, place.hi + by}, halo, name,
                       ui::Align::center);
    ui::paint_text(theme.font.small_strong, place, color, name, ui::Align::center);
}

} // namespace

ui::Color axis_color(const ui::Theme& theme, int axis)
{
    const ui::Palette& c = theme.color;
    return axis == 0 ? c.axis_x : axis == 1 ? c.axis_y : c.axis_z;
}

void paint_gizmo(const ui::Theme& theme, glm::vec2 at, const std::vector<HandleShape>& shapes,
                 GizmoHandle lit)
{
    for (const HandleShape& shape : shapes)
        if (shape.handle != lit) paint(theme, at, shape, false);
    for (const HandleShape& shape : shapes)
        if (shape.handle == lit) paint(theme, at, shape, true);
}

void paint_turn(const ui::Theme& theme, glm::vec2 at, const Camera& camera,
                const glm::dvec3& pivot_world, const glm::dvec3& axis, const glm::dvec3& from,
                double angle_deg, ui::Color color)
{
    const PicturePoint middle = project(camera, pivot_world);
    const glm::dvec3 flat = from - axis * glm::dot(from, axis);
    if (middle.depth_world <= 0 || glm::length(flat) < 1e-9) return;
    const double radius =
        ring_radius_px * theme.scale * pixel_size_world(camera, middle.depth_world);
    const glm::dvec3 u = glm::normalize(flat) * radius, v = glm::cross(axis, u);
    const auto arc = [&](double deg) {
        std::vector<glm::vec2> points;
        constexpr double step_deg = 4;
        const int steps = 1 + static_cast<int>(std::abs(deg) / step_deg);
        for (int i = 0; i <= steps; ++i) {
            const double a = glm::radians(deg * i / steps);
            points.push_back(
                at +
                glm::vec2(project(camera, pivot_world + u * std::cos(a) + v * std::sin(a)).p_px));
        }
        return points;
    };
    const std::vector<glm::vec2> turned = arc(std::clamp(angle_deg, -360.0, 360.0));
    const glm::vec2 center = at + glm::vec2(middle.p_px);
    const ui::Color halo = theme.color.halo;
    const float thin = theme.line(1.25f), thick = theme.line(4), edge = 1.75f * theme.scale;
    ui::paint_path(arc(360), halo, thin + edge);
    ui::paint_path(arc(360), ui::faded(color, 0.6f), thin);
    for (const glm::vec2 end : {turned.front(), turned.back()}) {
        ui::paint_line(center, end, halo, thin + edge);
        ui::paint_line(center, end, color, thin);
    }
    ui::paint_path(turned, halo, thick + edge);
    ui::paint_path(turned, color, thick);
}

void paint_axis_line(const ui::Theme& theme, const ui::Rect& picture, const Camera& camera,
                     const MotionFrame& frame, int axis)
{
    const glm::dvec3 d = frame.axes[axis];
    const PicturePoint middle = project(camera, frame.pivot);
    if (middle.depth_world <= 0) return;
    const double far = 50 * camera.size_px.y * pixel_size_world(camera, middle.depth_world);
    // An end that would lie behind the eye is drawn in to before it.
    const auto end = [&](double length) {
        const double change =
            project(camera, frame.pivot + d * length).depth_world - middle.depth_world;
        const double least = -0.99 * middle.depth_world;
        const double share = camera.perspective && change < least ? least / change : 1;
        return picture.lo + glm::vec2(project(camera, frame.pivot + d * (length * share)).p_px);
    };
    const glm::vec2 a = end(-far), b = end(far);
    const float width = theme.line(1.25f);
    ui::paint_line(a, b, theme.color.halo, width + 1.75f * theme.scale);
    ui::paint_line(a, b, axis_color(theme, axis), width);
}

} // namespace trivar
