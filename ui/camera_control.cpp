// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera_control.h"

#include "core/base/box.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::ui {
namespace {

// At the poles the picture would have no horizon: this near (radians) is near enough.
constexpr double pole_gap = 0.01;
constexpr double nearest_world = 1e-8, farthest_world = 1e10; // cells to countries

glm::dvec3 forward_of(const Camera& camera)
{
    return glm::normalize(camera.target - camera.eye);
}

glm::dvec3 right_of(const glm::dvec3& forward)
{
    const glm::dvec3 right = glm::cross(forward, glm::dvec3(0, 0, 1));
    const double length = glm::length(right);
    return length > 1e-9 ? right / length : glm::dvec3(1, 0, 0);
}

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    return glm::dvec3(glm::rotate(glm::dmat4(1), angle, axis) * glm::dvec4(v, 0));
}

} // namespace

Camera orbited(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 drag_px)
{
    const double per_px = glm::pi<double>() / std::max(1.0, camera.size_px.y);
    const glm::dvec3 forward = forward_of(camera);
    const double elevation = std::asin(std::clamp(forward.z, -1.0, 1.0));
    const double limit = glm::half_pi<double>() - pole_gap;
    const double pitch = std::clamp(elevation - drag_px.y * per_px, -limit, limit) - elevation;
    const double yaw = -drag_px.x * per_px;
    const glm::dvec3 right = right_of(forward);
    const auto turn = [&](const glm::dvec3& v) {
        return turned(turned(v, right, pitch), glm::dvec3(0, 0, 1), yaw);
    };
    Camera result = camera;
    result.up = {0, 0, 1};
    result.eye = pivot_world + turn(camera.eye - pivot_world);
    result.target = pivot_world + turn(camera.target - pivot_world);
    return result;
}

Camera panned(const Camera& camera, const glm::dvec3& anchor_world, glm::dvec2 drag_px)
{
    const double depth =
        std::max(nearest_world, glm::dot(anchor_world - camera.eye, forward_of(camera)));
    const glm::dvec3 right = right_of(forward_of(camera));
    const glm::dvec3 up = glm::cross(right, forward_of(camera));
    const glm::dvec3 shift =
        (right * -drag_px.x + up * drag_px.y) * pixel_size_world(camera, depth);
    Camera result = camera;
    result.eye += shift;
    result.target += shift;
    return result;
}

Camera zoomed(const Camera& camera, const glm::dvec3& anchor_world, double factor)
{
    const double distance =
        camera.perspective ? glm::distance(camera.eye, camera.target) : camera.height_world;
    factor = std::clamp(distance * factor, nearest_world, farthest_world) / distance;
    Camera result = camera;
    // A homothety about the anchor: no direction changes, so the anchor's pixel does not either.
    result.eye = anchor_world + (camera.eye - anchor_world) * factor;
    result.target = anchor_world + (camera.target - anchor_world) * factor;
    result.height_world = camera.height_world * factor;
    return result;
}

Camera framed(const Camera& camera, std::span<const glm::dvec3> points, double foot_px)
{
    if (points.empty()) return camera;
    constexpr double share = 0.8; // of the picture that the points fill
    Box box;
    for (const glm::dvec3& p : points) box.add(p);
    const glm::dvec3 middle = box.center(), forward = forward_of(camera);
    const glm::dvec3 across = glm::cross(forward, camera.up);
    const glm::dvec3 right =
        glm::length(across) > 1e-9 ? glm::normalize(across) : right_of(forward);
    const glm::dvec3 up = glm::cross(right, forward);
    const double aspect = camera.size_px.x / std::max(1.0, camera.size_px.y);
    const double foot = std::clamp(foot_px / std::max(1.0, camera.size_px.y), 0.0, 0.5);
    // Shares of half the picture between its middle and the ends of the box of the points.
    const double to_top = 1 - (1 - share) * (1 - foot);
    const double to_foot = to_top - 2 * foot;
    const double slope_y = camera.perspective ? std::tan(camera.fov_y / 2) : 0;
    const double slope_x = slope_y * share * aspect;
    const glm::dvec2 slope_up{slope_x, slope_y * to_top}, slope_down{slope_x, slope_y * to_foot};

    // A point is inside where |x - center| <= slope (z + distance), and likewise y: two bounds that
    // have to meet at the least distance.
    glm::dvec2 above(-1e300), below(-1e300);
    double nearest = 1e300;
    for (const glm::dvec3& p : points) {
        const glm::dvec3 d = p - middle;
        const glm::dvec2 at{glm::dot(d, right), glm::dot(d, up)};
        const double z = glm::dot(d, forward);
        above = glm::max(above, at - slope_up * z);
        below = glm::max(below, -at - slope_down * z);
        nearest = std::min(nearest, z);
    }
    glm::dvec2 center = (above - below) / 2.0;
    const glm::dvec2 width = above + below;
    Camera result = camera;
    double distance = 0; // from the eye to the middle
    if (camera.perspective) {
        distance = std::max(width.x / (2 * slope_x), width.y / (slope_up.y + slope_down.y));
        distance = std::max(distance, nearest_world - nearest);
    } else {
        result.height_world =
            std::max({nearest_world, width.x / aspect / share, width.y / ((to_top + to_foot) / 2)});
        distance = result.height_world - nearest;
    }
    distance = std::clamp(distance, nearest_world, farthest_world);
    const double half_height = camera.perspective ? slope_y * distance : result.height_world / 2;
    center.y -= half_height * foot; // up by half of what stays free
    const glm::dvec3 aim = middle + right * center.x + up * center.y;
    result.eye = aim - forward * distance;
    result.target = aim;
    return result;
}

Camera reshaped(const Camera& camera, glm::dvec2 size_px)
{
    constexpr double widest = 2.8; // radians; beyond it a picture is all rim
    Camera result = camera;
    result.size_px = glm::max(size_px, 1.0);
    const double before = camera.size_px.x / std::max(1.0, camera.size_px.y);
    const double now = result.size_px.x / result.size_px.y;
    if (now >= before) return result;
    result.height_world *= before / now;
    const double wider = 2 * std::atan(std::tan(camera.fov_y / 2) * before / now);
    result.fov_y = std::max(camera.fov_y, std::min(wider, widest));
    return result;
}

Camera seen_from(const Camera& camera, const glm::dvec3& direction)
{
    const glm::dvec3 level(direction.x, direction.y, 0);
    glm::dvec3 from = glm::normalize(direction);
    // Straight above or below: a trace towards Y, so that X goes to the right as on a map.
    if (glm::length(level) < std::sin(pole_gap))
        from = glm::dvec3(0, -std::sin(pole_gap), std::copysign(std::cos(pole_gap), direction.z));
    Camera result = camera;
    result.up = {0, 0, 1};
    result.eye = camera.target + from * glm::distance(camera.eye, camera.target);
    return result;
}

Camera with_perspective(const Camera& camera, bool perspective)
{
    if (camera.perspective == perspective) return camera;
    Camera result = camera;
    result.perspective = perspective;
    const double slope = 2 * std::tan(camera.fov_y / 2);
    if (perspective)
        result.eye = camera.target - forward_of(camera) * (camera.height_world / slope);
    else
        result.height_world = glm::distance(camera.eye, camera.target) * slope;
    return result;
}

glm::dvec3 point_at_target_depth(const Camera& camera, glm::dvec2 p_px)
{
    const Ray ray = ray_through(camera, p_px);
    const glm::dvec3 forward = forward_of(camera);
    const double depth = glm::dot(camera.target - ray.origin, forward);
    return ray.origin + ray.direction * (depth / glm::dot(ray.direction, forward));
}

} // namespace trivar::ui
