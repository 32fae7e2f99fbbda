// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

struct LiftOptions {
    double tolerance = 1e-3; // metres that may stay behind the scene
    double clearance = 0;    // metres to keep in front of it
    bool skip_back_faces = false;
    // No control point rises above what it is lifted over: over a cliff the shortest steps would
    // throw those on top of it as far up as those at its foot.
    bool never_overshoot = false;
};

struct LiftedSurface {
    Surface<glm::dvec3> contact;
    double penetration = 0; // largest left, metres
    double largest_gap = 0; // metres between contact surface and scene, along the rays
    int rounds = 0;
};

// Moves control points toward the camera until the surface lies in front of everything the camera
// sees, within the tolerance. judge() finds the points of the scene that are not; their control
// points move outward, each point's by the shortest step that satisfies it (Kaczmarz 1937), the
// deepest first; and it is judged again. One that never overshoots can be satisfied too: with all
// its control points level with the sample, so is the surface. Rays do most of it before in less
// time, and check it independently.
LiftedSurface lifted(Surface<glm::dvec3> contact, const Camera& camera, const RayScene& scene,
                     const LiftOptions& options);

} // namespace trivar
