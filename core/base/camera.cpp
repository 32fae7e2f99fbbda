// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

struct Frame {
    glm::dvec3 right, up, forward;
};

Frame frame_of(const Camera& camera)
{
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    glm::dvec3 right = glm::cross(forward, camera.up);
    // If the camera looks along `up`, its roll is free: any horizontal direction is right.
    if (glm::length(right) < 1e-9) right = glm::dvec3(1, 0, 0);
    right = glm::normalize(right);
    return {right, glm::cross(right, forward), forward};
}

double half_height(const Camera& camera, double depth_world)
{
    return camera.perspective ? std::tan(camera.fov_y / 2) * depth_world : camera.height_world / 2;
}

} // namespace

Ray ray_through(const Camera& camera, glm::dvec2 p_px)
{
    const Frame f = frame_of(camera);
    const double unit = 2 * half_height(camera, 1) / camera.size_px.y;
    const glm::dvec2 offset = (p_px - camera.size_px / 2.0) * glm::dvec2(unit, -unit);
    const glm::dvec3 across = f.right * offset.x + f.up * offset.y;
    if (camera.perspective) return {camera.eye, glm::normalize(f.forward + across)};
    return {camera.eye + across, f.forward};
}

PicturePoint project(const Camera& camera, const glm::dvec3& p_world)
{
    const Frame f = frame_of(camera);
    const glm::dvec3 d = p_world - camera.eye;
    const double depth = glm::dot(d, f.forward);
    const double pixels = 1 / pixel_size_world(camera, depth);
    return {camera.size_px / 2.0 + glm::dvec2(glm::dot(d, f.right), -glm::dot(d, f.up)) * pixels,
            depth};
}

double pixel_size_world(const Camera& camera, double depth_world)
{
    return 2 * half_height(camera, depth_world) / camera.size_px.y;
}

glm::dmat4 view_matrix(const Camera& camera)
{
    const Frame f = frame_of(camera);
    return glm::lookAt(camera.eye, camera.eye + f.forward, f.up);
}

glm::dmat4 projection_matrix(const Camera& camera, double near_world, double far_world)
{
    const double aspect = camera.size_px.x / camera.size_px.y;
    if (camera.perspective) return glm::perspective(camera.fov_y, aspect, near_world, far_world);
    const double h = camera.height_world / 2;
    return glm::ortho(-h * aspect, h * aspect, -h, h, near_world, far_world);
}

} // namespace trivar
