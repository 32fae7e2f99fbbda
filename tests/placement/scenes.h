// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/rays/ray_scene.h"

#include <functional>
#include <string>

namespace trivar::testing {

// z = height(x, y) over a square of the given size round the origin, steps x steps quads.
Mesh height_field(double size, int steps, const std::function<double(double, double)>& height);

RayScene scene_of(Mesh mesh, const glm::dmat4& to_world = glm::dmat4(1));

// Looks straight down; the picture shows `height` metres, 1000 pixels high and 1500 wide.
Camera from_above(double height = 2);
// In perspective, from the side and above.
Camera from_the_side(glm::dvec3 eye = {1, -4, 3});

// A stroke along a polyline of the picture, a sample every few pixels.
Sketch stroke(const Camera& camera, const std::vector<glm::dvec2>& corners_px);
// The same, along the picture of a line in the world.
Sketch stroke_over(const Camera& camera, const std::vector<glm::dvec3>& corners_world);

// A floor and one thing on it, in the way of stroke_to_cover().
struct NamedScene {
    std::string name;
    RayScene scene;
};
std::vector<NamedScene> scenes_to_cover();
Sketch stroke_to_cover(const Camera& camera);

Box snake_box(); // ten long, two wide, one high
Placement placed(const Sketch& sketch, const RayScene& scene, const PlacementParameters& p = {});

// The snake along a stroke over waves, seen from the side.
Placement over_waves(const PlacementParameters& p);

// How far the contact surface lies behind what the camera sees, largest over an n x n grid.
double penetration(const Surface<glm::dvec3>& contact, const Camera& camera, const RayScene& scene,
                   int n);

} // namespace trivar::testing
