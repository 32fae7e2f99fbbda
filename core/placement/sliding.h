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

// Returns the place of the scene under a point near it, along its normal. Its normal is the mean
// over a disc, so that it does not jump from face to face. Nothing: there is no scene. 17 rays.
//   reach  metres to both sides, and the radius of the disc
std::optional<Ground> ground_under(const RayScene& scene, const Ground& near, double reach);

// The same where a ray first meets the scene.
std::optional<Ground> ground_hit(const RayScene& scene, const Ray& ray, double reach);

// The place that is so far away along the surface, in metres, straight on in the direction given.
// Where the scene ends it goes straight on. Steps of at most a quarter of `reach`, at most 400.
Ground walked(const RayScene& scene, Ground from, const glm::dvec3& along, double distance,
              double reach);

// Returns the turn and shift that take one ground to another. Across level ground the heading
// stays; on a steep wall, upright stays upright.
glm::dmat4 slid(const Ground& from, const Ground& to);

// The turn about the ground's normal, right-handed, and the scaling about its place.
glm::dmat4 turned_on(const Ground& ground, double angle_deg);
glm::dmat4 grown_on(const Ground& ground, double factor);

// Moves a stroke, with its camera.
//   by      turns, scales evenly and shifts
//   before  the scene on which it fell
//   scene   the scene on which it falls now
//   above   where it is after the motion
// If something now stands between the camera and the place to which the stroke was moved, the same
// stroke is seen from close above that place, in parallel.
Sketch moved_stroke(const Sketch& sketch, const glm::dmat4& by, const RayScene& before,
                    const RayScene& scene, const Ground& above);

} // namespace trivar
