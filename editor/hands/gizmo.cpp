// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gizmo.h"

#include "editor/hands/hand_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

// Lengths in pixels at scale 1.
constexpr double shaft_from = 16, shaft_to = 74, shaft_end = 90, letter_at = 104;
constexpr double plane_from = 27, plane_to = 43;
constexpr double view_ring = 98, center_radius = 8;
constexpr double head_half = 5.5, box_half = 5.5;

// Between these lengths, of its full one, an axis that points at the eye fades out.
constexpr double gone = 0.12, whole = 0.3;
float opacity_of(double share)
{
    return static_cast<float>(std::clamp((share - gone) / (whole - gone), 0.0, 1.0));
}

// Pixels at scale 1 about a point of the scene.
class Sketcher {
public:
    Sketcher(const Camera& camera, const glm::dvec3& pivot, double scale)
        : camera_(camera),
          pivot_(pivot),
          scale_(scale),
          unit_(pixel_size_world(camera, project(camera, pivot).depth_world) * scale)
    {
    }
    glm::vec2 at(const glm::dvec3& direction, double length) const
    {
        return glm::vec2(project(camera_, pivot_ + direction * (length * unit_)).p_px);
    }
    glm::vec2 beside(const glm::dvec3& direction, double length, glm::vec2 shift) const
    {
        return at(direction, length) + shift * static_cast<float>(scale_);
    }
    glm::vec2 center() const { return at({0, 0, 0}, 0); }
    std::vector<glm::vec2> circle(double radius) const
    {
        std::vector<glm::vec2> points;
        constexpr int steps = 64;
        for (int i = 0; i < steps; ++i) {
            const double a = 2 * std::numbers::pi * i / steps;
            points.push_back(center() + glm::vec2(std::cos(a), std::sin(a)) *
                                            static_cast<float>(radius * scale_));
        }
        return points;
    }
    std::vector<glm::vec2> box(glm::vec2 middle, double half) const
    {
        const auto h = static_cast<float>(half * scale_);
        return {middle + glm::vec2(-h, -h), middle + glm::vec2(h, -h), middle + glm::vec2(h, h),
                middle + glm::vec2(-h, h)};
    }

private:
    const Camera& camera_;
    glm::dvec3 pivot_;
    double scale_, unit_;
};

HandleShape axis_shape(MotionKind kind, const Sketcher& s, const glm::dvec3& d, int axis,
                       double share)
{
    HandleShape shape{.handle = {Grip::axis, axis}, .opacity = opacity_of(share)};
    shape.line = {s.at(d, shaft_from), s.at(d, shaft_to)};
    const glm::vec2 along = glm::normalize(s.at(d, shaft_end) - s.center());
    const glm::vec2 across{-along.y, along.x};
    if (kind == MotionKind::move)
        shape.area = {s.at(d, shaft_end),
                      s.beside(d, shaft_to, across * static_cast<float>(head_half)),
                      s.beside(d, shaft_to, -across * static_cast<float>(head_half))};
    else
        shape.area = s.box(s.at(d, shaft_to + box_half), box_half);
    shape.letter = s.beside(d, shaft_end, along * static_cast<float>(letter_at - shaft_end));
    return shape;
}

HandleShape plane_shape(const Sketcher& s, const MotionFrame& frame, int axis, double facing)
{
    const glm::dvec3 u = frame.axes[(axis + 1) % 3], v = frame.axes[(axis + 2) % 3];
    HandleShape shape{.handle = {Grip::plane, axis}, .closed = true, .opacity = opacity_of(facing)};
    const auto corner = [&](double a, double b) { return s.at(u * a + v * b, 1); };
    shape.line = {corner(plane_from, plane_from), corner(plane_to, plane_from),
                  corner(plane_to, plane_to), corner(plane_from, plane_to)};
    shape.area = shape.line;
    return shape;
}

HandleShape ring_shape(const Sketcher& s, const MotionFrame& frame, int axis, const glm::dvec3& eye)
{
    const glm::dvec3 d = frame.axes[axis];
    HandleShape shape{.handle = {Grip::ring, axis}};
    // Start where the ring passes behind: only the front half is drawn, unless seen from above.
    const bool all = std::abs(glm::dot(d, eye)) > 0.985;
    const glm::dvec3 side = glm::cross(d, eye);
    const glm::dvec3 u =
        glm::length(side) > 1e-6 ? glm::normalize(side) : frame.axes[(axis + 1) % 3];
    const glm::dvec3 v = glm::cross(u, d) * (glm::dot(glm::cross(u, d), eye) < 0 ? -1.0 : 1.0);
    constexpr int steps = 48;
    for (int i = 0; i <= steps; ++i) {
        const double a = std::numbers::pi * i / steps;
        shape.line.push_back(s.at(u * std::cos(a) + v * std::sin(a), ring_radius_px));
        shape.back.push_back(s.at(u * std::cos(a) - v * std::sin(a), ring_radius_px));
    }
    if (all) {
        shape.back.pop_back();
        std::reverse(shape.back.begin(), shape.back.end());
        shape.back.pop_back();
        shape.line.insert(shape.line.end(), shape.back.begin(), shape.back.end());
        shape.back.clear();
        shape.closed = true;
    }
    return shape;
}

float distance_to_line(const std::vector<glm::vec2>& line, bool closed, glm::vec2 p)
{
    float nearest = 1e30f;
    const std::size_t n = line.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
        const glm::vec2 a = line[i], d = line[(i + 1) % n] - a;
        const float t = std::clamp(glm::dot(p - a, d) / std::max(1e-12f, glm::dot(d, d)), 0.f, 1.f);
        nearest = std::min(nearest, glm::distance(p, a + d * t));
    }
    return nearest;
}

// Convex, either way round.
bool contains(const std::vector<glm::vec2>& area, glm::vec2 p)
{
    bool left = false, right = false;
    for (std::size_t i = 0; i < area.size(); ++i) {
        const glm::vec2 d = area[(i + 1) % area.size()] - area[i], e = p - area[i];
        const float side = d.x * e.y - d.y * e.x;
        left = left || side > 0;
        right = right || side < 0;
    }
    return area.size() > 2 && left != right;
}

} // namespace

std::vector<HandleShape> gizmo_shapes(MotionKind kind, const Camera& camera,
                                      const MotionFrame& frame, double scale)
{
    if (project(camera, frame.pivot).depth_world <= 0) return {};
    const Sketcher s(camera, frame.pivot, scale);
    const glm::dvec3 eye = toward_eye(camera, frame.pivot);
    std::vector<HandleShape> shapes;
    if (kind == MotionKind::rotate) {
        for (int axis = 0; axis < 3; ++axis) shapes.push_back(ring_shape(s, frame, axis, eye));
        shapes.push_back({.handle = {Grip::view_ring, 0},
                          .line = s.circle(view_ring),
                          .closed = true,
                          .opacity = 0.6f});
        return shapes;
    }
    HandleShape middle{.handle = {Grip::center, 0}, .closed = true};
    middle.line =
        kind == MotionKind::move ? s.circle(center_radius) : s.box(s.center(), center_radius - 2);
    middle.area = middle.line;
    for (int axis = 0; axis < 3; ++axis) {
        const double facing = std::abs(glm::dot(frame.axes[axis], eye));
        const double seen = std::sqrt(std::max(0.0, 1 - facing * facing));
        if (opacity_of(facing) > 0) shapes.push_back(plane_shape(s, frame, axis, facing));
        if (opacity_of(seen) > 0)
            shapes.push_back(axis_shape(kind, s, frame.axes[axis], axis, seen));
    }
    shapes.push_back(middle);
    return shapes;
}

GizmoHandle handle_at(const std::vector<HandleShape>& shapes, glm::vec2 p_px, double scale)
{
    auto nearest = static_cast<float>(7 * scale);
    GizmoHandle result;
    // The shape painted last lies on top.
    for (auto it = shapes.rbegin(); it != shapes.rend(); ++it) {
        if (it->opacity < 0.25f) continue;
        const float d = contains(it->area, p_px)
                            ? 0.0f
                            : std::min(distance_to_line(it->line, it->closed, p_px),
                                       distance_to_line(it->area, true, p_px));
        if (d >= nearest) continue;
        nearest = d;
        result = it->handle;
    }
    return result;
}

} // namespace trivar
