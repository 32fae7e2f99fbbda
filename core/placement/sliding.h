// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/rays/ray_scene.h"

#include <optional>

namespace trivar {

// These functions move a stroke as a whole over the scene on which it falls: its camera goes with
// it, so that the stroke in its picture stays as it was drawn.

// A Ground is a place on the scene. The normal is unit and points to the side that is seen.
struct Ground {
    glm::dvec3 p{0}, normal{0, 0, 1};
};

// The place of the scene under a point near it, along the normal given: within `reach`, metres, to
// both sides. Its normal is the mean over a disc of that radius, so that it does not jump from face
// to face. Nothing: there is no scene. 17 rays.
std::optional<Ground> ground_under(const RayScene& scene, const Ground& near, double reach);

// The same where a ray first meets the scene.
std::optional<Ground> ground_hit(const RayScene& scene, const Ray& ray, double reach);

// The place that is so far away along the surface, in metres, straight on in the direction given.
// Where the scene ends it goes straight on. Steps of at most a quarter of `reach`, at most 400.
Ground walked(const RayScene& scene, Ground from, const glm::dvec3& along, double distance,
              double reach);

// The turn and shift that take one ground to another. Across level ground the heading stays; what
// stands upright on a steep wall stays upright.
glm::dmat4 slid(const Ground& from, const Ground& to);

// The turn about the ground's normal, right-handed, and the scaling about its place.
glm::dmat4 turned_on(const Ground& ground, double angle_deg);
glm::dmat4 grown_on(const Ground& ground, double factor);

// The stroke after a motion that turns, scales evenly and shifts, its camera moved along. Where
// something now stands between that camera and the place to which the stroke was moved, the same
// stroke is seen from close above that place, in parallel. `before` is the scene on which it fell,
// `scene` the one it falls on now; `above` says where it is after the motion.
Sketch moved_stroke(const Sketch& sketch, const glm::dmat4& by, const RayScene& before,
                    const RayScene& scene, const Ground& above);

} // namespace trivar
