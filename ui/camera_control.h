// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <span>

namespace trivar::ui {

// Each of these pure functions is a way in which a hand moves a camera. The horizon stays level:
// nothing rolls.

// Turns the camera about a world point, which keeps its place in the picture; a drag as long as the
// picture is high turns by half a circle. Turning ends at looking straight up or down.
Camera orbited(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 drag_px);

// Slides the camera sideways so that a point at the anchor's depth follows the drag exactly.
Camera panned(const Camera& camera, const glm::dvec3& anchor_world, glm::dvec2 drag_px);

// Moves the camera nearer (factor below 1) or further away; the anchor keeps its place in the
// picture. The distance from the target stays between 1e-8 and 1e10 metres.
Camera zoomed(const Camera& camera, const glm::dvec3& anchor_world, double factor);

// Keeps the direction and moves the camera so near that the points just fit the picture with a
// margin of a tenth at each side; afterwards it turns about the depth of their middle. Without
// points the camera stays. `foot_px` of the picture stay free at its foot, at most half of it.
Camera framed(const Camera& camera, std::span<const glm::dvec3> points, double foot_px = 0);

// The same view in a picture of another shape, wide enough for everything that was in it.
Camera reshaped(const Camera& camera, glm::dvec2 size_px);

// The same target and distance, seen from a direction (unit, from the target to the eye). From
// above and below X goes to the right, however the view was turned before.
Camera seen_from(const Camera& camera, const glm::dvec3& direction);

// Switches between perspective and orthographic; things at the target's depth keep their size.
Camera with_perspective(const Camera& camera, bool perspective);

// The point under a pixel at the depth of the target: an anchor where the ray hits nothing.
glm::dvec3 point_at_target_depth(const Camera& camera, glm::dvec2 p_px);

} // namespace trivar::ui
