// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// A Camera is a point of view, by value. World space is right-handed with Z up, in metres.
struct Camera {
    glm::dvec3 eye{4, -6, 3};
    glm::dvec3 target{0, 0, 0};
    glm::dvec3 up{0, 0, 1};
    bool perspective = true;
    double fov_y = 0.6;            // radians, the full vertical angle; perspective only
    double height_world = 4;       // world height of the picture; orthographic only
    glm::dvec2 size_px{1280, 720}; // the picture to which its pixel coordinates refer

    bool operator==(const Camera&) const = default;
};

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction; // unit
};

// The ray through a pixel position; (0, 0) is the top left corner of the picture, y goes down.
Ray ray_through(const Camera& camera, glm::dvec2 p_px);

// A PicturePoint is where a world point appears, in pixels, and its distance along the view
// direction (negative: behind the camera).
struct PicturePoint {
    glm::dvec2 p_px;
    double depth_world;
};
PicturePoint project(const Camera& camera, const glm::dvec3& p_world);

// World length of one pixel at the given depth along the view direction.
double pixel_size_world(const Camera& camera, double depth_world);

glm::dmat4 view_matrix(const Camera& camera);
// OpenGL clip space; near and far are distances along the view direction.
glm::dmat4 projection_matrix(const Camera& camera, double near_world, double far_world);

} // namespace trivar
