// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "editor/hands/motion.h"
#include "ui/paint.h"

#include <vector>

namespace trivar {

// A Grip is the part of a handle that a hand can take: an arrow or box of an axis, a ring about it,
// the plane across it, the ring of the picture, or the middle.
enum class Grip { none, axis, plane, ring, view_ring, center };
struct GizmoHandle {
    Grip grip = Grip::none;
    int axis = 0; // 0, 1, 2; for a plane the axis across it
    bool operator==(const GizmoHandle&) const = default;
};

// A HandleShape is one of them as it appears in the picture, in pixels.
struct HandleShape {
    GizmoHandle handle;
    std::vector<glm::vec2> line = {}; // drawn open
    std::vector<glm::vec2> area = {}; // filled
    std::vector<glm::vec2> back =
        {};              // of a ring: behind the object, faint, cannot be taken hold of
    glm::vec2 letter{0}; // where the name of the axis stands
    bool closed = false; // whether the line is closed
    float opacity = 1;   // fades where the view makes it useless
};

// The handles of a tool round a point: of the same size in pixels in every view. Handles whose
// direction cannot be seen are left out. Empty where the point is behind the eye.
std::vector<HandleShape> gizmo_shapes(MotionKind kind, const Camera& camera,
                                      const MotionFrame& frame, double scale);

// The handle under a pixel; the nearest one where there are several.
GizmoHandle handle_at(const std::vector<HandleShape>& shapes, glm::vec2 p_px, double scale);

// The distance of a ring from the pivot, in pixels at scale 1.
inline constexpr double ring_radius_px = 82;

// Paints the handles, `lit` above the others; `at` is where the picture begins in the window.
void paint_gizmo(const ui::Theme& theme, glm::vec2 at, const std::vector<HandleShape>& shapes,
                 GizmoHandle lit);

ui::Color axis_color(const ui::Theme& theme, int axis);

// Paints how far something was turned about a unit axis through the pivot, beginning at a
// direction: the ring, and on it the arc between two radii. Angles beyond a whole turn fill the
// ring.
void paint_turn(const ui::Theme& theme, glm::vec2 at, const Camera& camera,
                const glm::dvec3& pivot_world, const glm::dvec3& axis, const glm::dvec3& from,
                double angle_deg, ui::Color color);

// Paints a line through the frame's pivot along one of its axes, across the whole picture.
void paint_axis_line(const ui::Theme& theme, const ui::Rect& picture, const Camera& camera,
                     const MotionFrame& frame, int axis);

} // namespace trivar
