// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/hand_motion.h"

#include <cmath>

namespace trivar {
namespace {

// The parameter of the line's point that is nearest to the ray through a pixel.
std::optional<double> on_line(const Camera& camera, const glm::dvec3& p, const glm::dvec3& d,
                              glm::dvec2 p_px)
{
    const Ray ray = ray_through(camera, p_px);
    const glm::dvec3 w = p - ray.origin;
    const double b = glm::dot(d, ray.direction), det = 1 - b * b;
    constexpr double steep = 0.01; // six degrees: the line's end is under the eye
    if (det < steep) return {};
    const double along_ray = (glm::dot(w, ray.direction) - b * glm::dot(w, d)) / det;
    if (along_ray <= 0) return {}; // behind the eye
    return (b * glm::dot(w, ray.direction) - glm::dot(w, d)) / det;
}

double pixel_at(const Camera& camera, const glm::dvec3& p)
{
    return pixel_size_world(camera, std::max(1e-9, project(camera, p).depth_world));
}

} // namespace

std::optional<glm::dvec3> point_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                                         const glm::dvec3& normal, glm::dvec2 p_px)
{
    const Ray ray = ray_through(camera, p_px);
    const double slope = glm::dot(normal, ray.direction);
    constexpr double grazing = 0.05;
    if (std::abs(slope) < grazing) return {};
    const double t = glm::dot(normal, pivot_world - ray.origin) / slope;
    if (t <= 0) return {};
    return ray.origin + ray.direction * t;
}

glm::dmat3 view_axes(const Camera& camera)
{
    const glm::dmat4 m = glm::transpose(view_matrix(camera)); // its rows are the directions
    const glm::dvec3 right(m[0]), back(m[2]);
    // A view from the top keeps a hair off the vertical (0.01); what is moved in it stays level.
    const bool from_pole = std::abs(back.z) > std::cos(0.0101) && std::abs(right.z) < 1e-9;
    const glm::dvec3 axis = from_pole ? glm::dvec3(0, 0, std::copysign(1, back.z)) : back;
    return {right, from_pole ? glm::cross(axis, right) : glm::dvec3(m[1]), axis};
}

glm::dvec3 toward_eye(const Camera& camera, const glm::dvec3& p_world)
{
    if (!camera.perspective) return glm::normalize(camera.eye - camera.target);
    const glm::dvec3 d = camera.eye - p_world;
    return glm::length(d) > 0 ? glm::normalize(d) : view_axes(camera)[2];
}

double dragged_along(const Camera& camera, const glm::dvec3& pivot_world,
                     const glm::dvec3& direction, glm::dvec2 from_px, glm::dvec2 to_px)
{
    const auto from = on_line(camera, pivot_world, direction, from_px);
    const auto to = on_line(camera, pivot_world, direction, to_px);
    if (from && to) return *to - *from;
    const glm::dvec3 across = dragged_across(camera, pivot_world, from_px, to_px);
    const glm::dvec3 up = view_axes(camera)[1];
    const glm::dvec3 flat =
        direction - view_axes(camera)[2] * glm::dot(direction, view_axes(camera)[2]);
    // The line as projected into the picture, or straight up if it has no length there.
    return glm::length(flat) > 0.2 ? glm::dot(across, flat) / glm::dot(flat, flat)
                                   : glm::dot(across, up);
}

glm::dvec3 dragged_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                            const glm::dvec3& normal, glm::dvec2 from_px, glm::dvec2 to_px)
{
    const auto from = point_in_plane(camera, pivot_world, normal, from_px);
    const auto to = point_in_plane(camera, pivot_world, normal, to_px);
    if (from && to) return *to - *from;
    const glm::dvec3 across = dragged_across(camera, pivot_world, from_px, to_px);
    return across - normal * glm::dot(across, normal);
}

glm::dvec3 dragged_across(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 from_px,
                          glm::dvec2 to_px)
{
    const glm::dvec2 drag = (to_px - from_px) * pixel_at(camera, pivot_world);
    const glm::dmat3 view = view_axes(camera);
    return view[0] * drag.x - view[1] * drag.y;
}

double swept_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                 glm::dvec2 from_px, glm::dvec2 to_px)
{
    const glm::dvec2 center = project(camera, pivot_world).p_px;
    const glm::dvec2 a = from_px - center, b = to_px - center;
    if (a == b) return 0;
    // Pixels count downward, so that a positive cross product is a turn to the right.
    const double right = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    const double facing = glm::dot(axis, toward_eye(camera, pivot_world));
    return glm::degrees(facing >= 0 ? -right : right);
}

double followed_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                    glm::dvec2 from_px, glm::dvec2 to_px)
{
    const auto from = point_in_plane(camera, pivot_world, axis, from_px);
    const auto to = point_in_plane(camera, pivot_world, axis, to_px);
    if (!from || !to) return swept_deg(camera, pivot_world, axis, from_px, to_px);
    const glm::dvec3 a = *from - pivot_world, b = *to - pivot_world;
    return glm::degrees(std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b)));
}

double rolled_deg(const Camera& camera, const glm::dvec3& axis, double radius_px,
                  glm::dvec2 from_px, glm::dvec2 to_px)
{
    const glm::dmat3 view = view_axes(camera);
    const glm::dvec2 drag(to_px.x - from_px.x, from_px.y - to_px.y); // right and up
    // The side of the ring that looks at the eye moves along axis x (toward the eye).
    const glm::dvec3 tangent = glm::cross(axis, view[2]);
    const double length = glm::length(tangent);
    if (length < 1e-9) return 0;
    const double along = glm::dot(view[0] * drag.x + view[1] * drag.y, tangent / length);
    return glm::degrees(along / radius_px);
}

double grown_by(const Camera& camera, const glm::dvec3& pivot_world, double reach_px,
                glm::dvec2 from_px, glm::dvec2 to_px)
{
    const glm::dvec2 center = project(camera, pivot_world).p_px;
    const glm::dvec2 a = from_px - center, drag = to_px - from_px;
    if (glm::length(a) < reach_px / 4) return 1 + (drag.x - drag.y) / reach_px;
    return 1 + glm::dot(drag, a) / glm::dot(a, a);
}

} // namespace trivar
