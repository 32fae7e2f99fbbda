// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <optional>

namespace trivar {

// These pure functions say how far a hand that drags from one pixel to another moves, turns or
// scales something in the scene. Where the view makes a direction unreadable they do the nearest
// readable thing; they never fail.

// The way along a line through the pivot (unit direction): the line's point that was under the
// mouse stays under it. A line that points at the eye follows the drag upward.
double dragged_along(const Camera& camera, const glm::dvec3& pivot_world,
                     const glm::dvec3& direction, glm::dvec2 from_px, glm::dvec2 to_px);

// The way in a plane through the pivot (unit normal): the plane's point under the mouse stays under
// it. A plane seen edge-on is replaced by the plane of the picture, and only the part of the way in
// the first plane counts.
glm::dvec3 dragged_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                            const glm::dvec3& normal, glm::dvec2 from_px, glm::dvec2 to_px);

// The way in the plane of the picture, at the pivot's depth.
glm::dvec3 dragged_across(const Camera& camera, const glm::dvec3& pivot_world, glm::dvec2 from_px,
                          glm::dvec2 to_px);

// The degrees about an axis through the pivot by which the mouse goes round it on the screen; -180
// to 180. Right-handed about the axis, which may point toward the eye or away from it.
double swept_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                 glm::dvec2 from_px, glm::dvec2 to_px);

// The same by the points of the plane across the axis: the point under the mouse stays under it.
// Where the mouse does not meet the plane, the angle on the screen counts.
double followed_deg(const Camera& camera, const glm::dvec3& pivot_world, const glm::dvec3& axis,
                    glm::dvec2 from_px, glm::dvec2 to_px);

// The degrees about an axis that lies nearly in the picture: a ring of this radius, seen edge-on,
// rolls with the mouse.
double rolled_deg(const Camera& camera, const glm::dvec3& axis, double radius_px,
                  glm::dvec2 from_px, glm::dvec2 to_px);

// The distance of the mouse from the pivot, relative to the beginning and along the line on which
// it began; negative on the other side. Where it begins at the pivot, `reach_px` to the right or up
// doubles.
double grown_by(const Camera& camera, const glm::dvec3& pivot_world, double reach_px,
                glm::dvec2 from_px, glm::dvec2 to_px);

// The point of a plane through the pivot (unit normal) under a pixel; empty where the plane is seen
// edge-on or the point lies behind the eye.
std::optional<glm::dvec3> point_in_plane(const Camera& camera, const glm::dvec3& pivot_world,
                                         const glm::dvec3& normal, glm::dvec2 p_px);

// The unit directions of the picture as columns: right, up, and toward the eye.
glm::dmat3 view_axes(const Camera& camera);
// The unit direction from a point toward the eye.
glm::dvec3 toward_eye(const Camera& camera, const glm::dvec3& p_world);

} // namespace trivar
