// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <span>

namespace trivar::ui {

// How a hand moves a camera; each is a pure function. The horizon stays level: nothing rolls.

// Turns about a world point, which keeps its place in the picture; a drag of the picture's height
// turns by half a circle. Looking straight up or down is the limit.
Camera orbited(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 drag_px);

// Slides sideways so that a point at the anchor's depth follows the drag exactly.
Camera panned(const Camera& camera, const glm::dvec3& anchor_world, glm::dvec2 drag_px);

// Comes nearer (factor below 1) or goes away; the anchor keeps its place in the picture. Between
// 1e-4 and 1e6 metres from the target the factor is obeyed, beyond that it is cut.
Camera zoomed(const Camera& camera, const glm::dvec3& anchor_world, double factor);

// The same direction, so near that the points just fit the picture with a margin of a tenth at each
// side, and turned about at the depth of their middle. No points give the camera as it was.
Camera framed(const Camera& camera, std::span<const glm::dvec3> points);

// The same view in a picture of another shape, wide enough for all that was in it.
Camera reshaped(const Camera& camera, glm::dvec2 size_px);

// The same target and distance, seen from a direction (unit, from the target to the eye).
Camera seen_from(const Camera& camera, const glm::dvec3& direction);

// From perspective to orthographic and back; what lies at the target's depth keeps its size.
Camera with_perspective(const Camera& camera, bool perspective);

// The point under a pixel at the depth of the target: an anchor where the ray hits nothing.
glm::dvec3 point_at_target_depth(const Camera& camera, glm::dvec2 p_px);

} // namespace trivar::ui
