// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "editor/tools/motion.h"
#include "ui/paint.h"

#include <vector>

namespace trivar {

// What a hand can take hold of: an arrow or box of an axis, a ring about it, the plane across it,
// the ring of the picture, or the middle.
enum class Grip { none, axis, plane, ring, view_ring, center };
struct Handle {
    Grip grip = Grip::none;
    int axis = 0; // 0, 1, 2; of a plane the one that stands on it
    bool operator==(const Handle&) const = default;
};

// A handle as it appears in the picture, pixels.
struct HandleShape {
    Handle handle;
    std::vector<glm::vec2> line = {}; // drawn open
    std::vector<glm::vec2> area = {}; // filled
    std::vector<glm::vec2> back =
        {};              // of a ring: behind the object, faint, cannot be taken hold of
    glm::vec2 letter{0}; // where the name of the axis stands
    bool closed = false; // the line is
    float opacity = 1;   // fades where the view makes it useless
};

// The handles of a tool round a point: always of the same size in pixels, whatever the view.
// Those whose direction cannot be seen are left out. Nothing where the point is behind the eye.
std::vector<HandleShape> gizmo_shapes(MotionKind kind, const Camera& camera,
                                      const MotionFrame& frame, double scale);

// The handle under a pixel; the nearest one where several are.
Handle handle_at(const std::vector<HandleShape>& shapes, glm::vec2 p_px, double scale);

// How far from the pivot a ring lies, pixels at scale 1.
inline constexpr double ring_radius_px = 82;

// Paints them, `lit` above the others; `at` is where the picture begins in the window.
void paint_gizmo(const ui::Theme& theme, glm::vec2 at, const std::vector<HandleShape>& shapes,
                 Handle lit);

ui::Color axis_color(const ui::Theme& theme, int axis);

// How far something was turned about a unit axis through the pivot, from a direction on: the ring,
// and on it the arc between two radii. Angles beyond a whole turn fill it.
void paint_turn(const ui::Theme& theme, glm::vec2 at, const Camera& camera,
                const glm::dvec3& pivot_world, const glm::dvec3& axis, const glm::dvec3& from,
                double angle_deg, ui::Color color);

// A line through the frame's pivot along one of its axes, across the whole picture.
void paint_axis_line(const ui::Theme& theme, const ui::Rect& picture, const Camera& camera,
                     const MotionFrame& frame, int axis);

} // namespace trivar
