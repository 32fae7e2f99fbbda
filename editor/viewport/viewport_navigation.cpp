// SPDX-License-Identifier: GPL-3.0-or-later
// The camera's share of the mouse, and what a ray of the picture meets.
#include "core/base/box.h"
#include "editor/session/session_facts.h"
#include "editor/viewport/viewport.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

glm::dvec3 world(const glm::dmat4& to_world, const Mesh& mesh, std::uint32_t vertex)
{
    return glm::dvec3(to_world * glm::dvec4(mesh.positions[vertex], 1));
}

// Distance along the ray to the triangle, or nothing (Moeller and Trumbore 1997, both sides).
std::optional<double> meet(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
    const double det = glm::dot(ab, p);
    if (std::abs(det) < 1e-300) return std::nullopt;
    const glm::dvec3 s = ray.origin - a, q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / det, v = glm::dot(ray.direction, q) / det;
    const double t = glm::dot(ac, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || t <= 0) return std::nullopt;
    return t;
}

// The distance along the ray to the nearest face, or `nearest` where none is nearer.
double nearest_face(const Mesh& mesh, const glm::dmat4& to_world, const Ray& ray, double nearest)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        const glm::dvec3 a = world(to_world, mesh, mesh.corners[begin]);
        for (std::uint32_t c = begin + 1; c + 1 < end; ++c) // a fan is near enough here
            if (const auto t = meet(ray, a, world(to_world, mesh, mesh.corners[c]),
                                    world(to_world, mesh, mesh.corners[c + 1])))
                nearest = std::min(nearest, *t);
    }
    return nearest;
}

// Whether the ray meets the box nearer than that.
bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& along, double nearer_than)
{
    double from = 0, to = nearer_than;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.lo[axis] - origin[axis]) / along[axis],
                     b = (box.hi[axis] - origin[axis]) / along[axis];
        from = std::max(from, std::min(a, b)); // not a number, in a side's plane: no bound
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

// The same for tiles, of which only those are bent whose hull the ray meets.
double nearest_tile(const TileSet& tiles, const glm::dmat4& to_world, const Ray& ray,
                    double nearest)
{
    const glm::dmat4 back = glm::inverse(to_world);
    const glm::dvec3 origin(back * glm::dvec4(ray.origin, 1)),
        along(back * glm::dvec4(ray.direction, 0));
    for (std::size_t i = 0; i < tiles.extents.size(); ++i)
        if (meets(tiles.extents[i].hull, origin, along, nearest))
            nearest = nearest_face(bent_tiles(*tiles.model->mesh, {&(*tiles.tiles)[i], 1}),
                                   to_world, ray, nearest);
    return nearest;
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
                                          : nearest_face(*part.mesh(), part.to_world, ray, nearest);
    if (nearest > 1e299) return std::nullopt;
    return ray.origin + ray.direction * nearest;
}

std::optional<glm::dvec3> Viewport::anchor_under(const Session& session, glm::dvec2 p_px)
{
    if (!renderer_ || !shown_) return std::nullopt;
    const auto found = session.evaluated().objects.find(renderer_->pick(glm::ivec2(p_px)));
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
    // Beside everything, the middle of the picture: a point under the mouse there would carry what
    // is looked at out of sight.
    return anchor_under(session, mouse_px).value_or(session.view.camera.target);
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
