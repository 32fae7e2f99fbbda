// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's share of the mouse, and what a ray of the picture meets.
#include "core/patches/tile_ray.h"
#include "core/rays/nearest_face.h"
#include "editor/session/session_facts.h"
#include "editor/viewport/viewport.h"

#include "editor/viewport/viewport_drawn.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// The length along a ray at which it meets tiles, or `nearest` where none is nearer.
double nearest_tile(const TileSet& tiles, const glm::dmat4& to_world, const Ray& ray,
                    double nearest)
{
    const glm::dmat4 back = glm::inverse(to_world);
    const glm::dvec3 origin(back * glm::dvec4(ray.origin, 1)),
        along(back * glm::dvec4(ray.direction, 0));
    const std::optional<TileHit> hit = first_tile(tiles, origin, along, nearest);
    return hit ? hit->t : nearest;
}

} // namespace

bool is_fine_scroll(glm::dvec2 steps)
{
    return steps.x != 0 || steps.y != std::round(steps.y);
}

std::optional<glm::dvec3> first_hit(const EvaluatedObject& object, const Ray& ray)
{
    double nearest = 1e300;
    for (const Part& part : object.parts)
        nearest = part.drawn_from_tiles() ? nearest_tile(*part.tiles, part.to_world, ray, nearest)
                                          : nearest_face(*part.mesh(), part.to_world, ray.origin,
                                                         ray.direction, nearest);
    if (nearest > 1e299) return std::nullopt;
    return ray.origin + ray.direction * nearest;
}

std::optional<glm::dvec3> Viewport::anchor_under(const Session& session, glm::dvec2 p_px)
{
    if (!drawn_->renderer || !drawn_->shown) return std::nullopt;
    const auto found = session.evaluated().objects.find(drawn_->renderer->pick(glm::ivec2(p_px)));
    if (found == session.evaluated().objects.end()) return std::nullopt;
    return first_hit(*found->second, ray_through(session.view.camera, p_px));
}

glm::dvec3 Viewport::point_under(const Session& session, glm::dvec2 p_px)
{
    return anchor_under(session, p_px)
        .value_or(ui::point_at_target_depth(session.view.camera, p_px));
}

glm::dvec3 Viewport::orbit_center(const Session& session, glm::dvec2 mouse_px)
{
    if (manners_.orbit_about == "origin") return glm::dvec3(0);
    Box box;
    if (manners_.orbit_about == "selection" && session.selected != 0)
        for (const glm::dvec3& p : points_of(session, session.selected.ids())) box.add(p);
    if (!box.empty()) return box.center();
    // Beside everything and far behind it, the middle of the picture: a point under the mouse there
    // would carry what is looked at out of sight.
    constexpr double far_behind = 1.5; // times as far away as the middle
    const Camera& camera = session.view.camera;
    const std::optional<glm::dvec3> anchor = anchor_under(session, mouse_px);
    const double middle = project(camera, camera.target).depth_world;
    const bool near = anchor && project(camera, *anchor).depth_world <= far_behind * middle;
    return near ? *anchor : camera.target;
}

bool Viewport::emulates_middle() const
{
    const ImGuiIO& io = ImGui::GetIO();
    return (manners_.emulation == "alt" && io.KeyAlt) ||
           (manners_.emulation == "super" && io.KeySuper) ||
           (manners_.emulation == "space" && ui::is_down(ui::key_space));
}

void Viewport::zoom(Session& session, glm::dvec2 mouse_px, double factor)
{
    Camera& camera = session.view.camera;
    const glm::dvec3 anchor =
        point_under(session, manners_.zoom_to_cursor ? mouse_px : camera.size_px / 2.0);
    camera = ui::zoomed(camera, anchor, factor);
    // Zooming on something far off the target would leave the target's depth behind: keep the
    // target at the depth of what is looked at.
    const double depth = project(camera, anchor).depth_world;
    if (depth > 1e-4 && camera.perspective)
        camera.target = camera.eye + glm::normalize(camera.target - camera.eye) * depth;
}

void Viewport::navigate(Session& session, const ViewportInput& input, glm::dvec2 drag_px)
{
    const ImGuiIO& io = ImGui::GetIO();
    Camera& camera = session.view.camera;
    const bool middle = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    const bool emulated = emulates_middle() && ImGui::IsItemActive() &&
                          ImGui::IsMouseDown(ImGuiMouseButton_Left) && !left_down_;
    if (!middle && !emulated) {
        move_ = Move::none;
    } else if (move_ == Move::none) {
        move_ = io.KeyShift ? Move::pan : io.KeyCtrl ? Move::zoom : Move::orbit;
        anchor_ = move_ == Move::orbit ? orbit_center(session, input.mouse)
                  : move_ == Move::zoom && !manners_.zoom_to_cursor
                      ? point_under(session, camera.size_px / 2.0)
                      : point_under(session, input.mouse);
    } else if (drag_px != glm::dvec2(0)) {
        if (move_ == Move::orbit) {
            session.view.turned();
            camera = ui::orbited(camera, anchor_, drag_px * manners_.orbit);
        }
        if (move_ == Move::pan) camera = ui::panned(camera, anchor_, drag_px * manners_.pan);
        const double way = manners_.reversed_zoom ? -manners_.zoom : manners_.zoom;
        if (move_ == Move::zoom)
            camera = ui::zoomed(camera, anchor_, std::exp2(way * drag_px.y / 120));
    }
}

void Viewport::scroll(Session& session, const ui::Frame& frame, const ViewportInput& input)
{
    constexpr double wheel_factor = 0.86, finger_px = 12, memory_s = 1;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 steps(io.MouseWheelH, io.MouseWheel);
    if (!input.hovered || steps == glm::dvec2(0)) return;
    if (is_fine_scroll(steps)) fine_scroll_s_ = frame.time_s;
    // A step of two fingers may be whole by chance.
    const bool fingers =
        manners_.device == "trackpad" ||
        (manners_.device == "automatic" && frame.time_s - fine_scroll_s_ < memory_s);
    Camera& camera = session.view.camera;
    if (!fingers || io.KeyCtrl) {
        const double way = manners_.reversed_zoom ? -manners_.zoom : manners_.zoom;
        zoom(session, input.mouse, std::pow(wheel_factor, way * steps.y));
        return;
    }
    const glm::dvec2 drag_px = steps * finger_px * input.scale;
    if (io.KeyShift)
        camera = ui::panned(camera, point_under(session, input.mouse), drag_px * manners_.pan);
    else
        camera = ui::orbited(camera, orbit_center(session, input.mouse), drag_px * manners_.orbit);
}

} // namespace trivar
