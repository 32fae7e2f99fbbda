// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <optional>

namespace trivar {

// How far a hand that drags from one pixel to another moves, turns or grows something in the scene,
// as pure functions. Where the view makes a direction unreadable the nearest readable thing is
// done; nothing here fails.

// Along a line through the pivot (unit direction): the line's point that was under the mouse stays
// under it. A line that points at the eye follows the drag upward.
double dragged_along(const Camera& camera, const glm::dvec3& pivot_world,
                     const glm::dvec3& direction, glm::dvec2 from_px, glm::dvec2 to_px);

// In a plane through the pivot (unit normal): the plane's point under the mouse stays under it. A
// plane seen from its edge is left for the plane of the picture, and only the part that lies in it
// counts.
glm::dvec3 dragged_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                            const glm::dvec3& normal, glm::dvec2 from_px, glm::dvec2 to_px);

// In the plane of the picture, at the pivot's depth.
glm::dvec3 dragged_across(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 from_px,
                          glm::dvec2 to_px);

// Degrees about an axis through the pivot, by the angle that the mouse sweeps round it on the
// screen; -180 to 180. Right-handed about the axis, which may look at the eye or away from it.
double swept_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                 glm::dvec2 from_px, glm::dvec2 to_px);

// The same by the points of the plane that stands on the axis: what was under the mouse stays under
// it. Where the plane cannot be met it is the sweep on the screen.
double followed_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                    glm::dvec2 from_px, glm::dvec2 to_px);

// Degrees about an axis that lies nearly in the picture: a ring of this radius seen from its edge
// rolls with the mouse.
double rolled_deg(const Camera& camera, const glm::dvec3& axis, double radius_px,
                  glm::dvec2 from_px, glm::dvec2 to_px);

// How many times as far from the pivot the mouse is, along the line on which it began; negative on
// the other side. Where it begins at the pivot, `reach_px` to the right or up doubles.
double grown_by(const Camera& camera, const glm::dvec3& pivot_world, double reach_px,
                glm::dvec2 from_px, glm::dvec2 to_px);

// The point of a plane through the pivot (unit normal) under a pixel; none where the plane is seen
// from its edge or there lies behind the eye.
std::optional<glm::dvec3> point_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                                         const glm::dvec3& normal, glm::dvec2 p_px);

// The unit directions of the picture as columns: right, up, and toward the eye.
glm::dmat3 view_axes(const Camera& camera);
// From a point toward the eye, unit.
glm::dvec3 toward_eye(const Camera& camera, const glm::dvec3& p_world);

} // namespace trivar
