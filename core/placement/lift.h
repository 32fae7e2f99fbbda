// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/rays/ray_scene.h"

namespace trivar {

struct LiftOptions {
    double tolerance = 1e-3; // metres of the surface that may stay behind the scene
    double clearance = 0;    // metres that the surface must keep in front of the scene
    bool skip_back_faces = false;
    // If set, control points are not lifted above the highest obstacle. Over a cliff the shortest
    // steps would throw control points on its top as far up as those at its foot.
    bool never_overshoot = false;
};

struct LiftedSurface {
    Surface<glm::dvec3> contact;
    double penetration = 0; // largest penetration that is left, metres
    double largest_gap = 0; // metres between contact surface and scene, along the rays
    int rounds = 0;
};

// Moves control points toward the camera until the surface lies in front of everything the camera
// sees, within the tolerance:
//
//      v    v    v    v    v        lines of sight
//             .------.
//      ------' lifted `-------      the contact surface
//             |  box |
//      _______|______|________      the scene
//
// judge() finds the points of the scene that are in front of the surface. The control points near
// each such point move outward by the shortest step that satisfies it (Kaczmarz 1937), the deepest
// point first; then the surface is judged again. With `never_overshoot` every sample can still be
// satisfied: where all its control points are level with it, so is the surface. Rays do most of the
// work beforehand in less time, and check the result independently.
LiftedSurface lifted(Surface<glm::dvec3> contact, const Camera& camera, const RayScene& scene,
                     const LiftOptions& options);

} // namespace trivar
