// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/camera.h"
#include "editor/hands/gizmo.h"
#include "editor/hands/motion.h"
#include "editor/hands/typed_amounts.h"

#include <string>
#include <vector>

namespace trivar {

enum class Orientation { world, local, view }; // the axes of a gesture; local: each object's own
// The point about which objects turn and grow: the middle of their origins, the middle of the box
// round what is seen, each object's own origin, or that of the active one.
enum class Pivot { origin, center, each, active };

// TransformChoices is what the options bar says; the tools share it.
struct TransformChoices {
    Orientation orientation = Orientation::world;
    Pivot pivot = Pivot::origin;
    double step_m = 0.25, step_deg = 5, step_factor = 0.1; // the steps to which Ctrl snaps
    double step(MotionKind kind) const
    {
        return kind == MotionKind::move     ? step_m
               : kind == MotionKind::rotate ? step_deg
                                            : step_factor;
    }
};

// The place of the handles, in the world. `active` is one of the objects.
glm::dvec3 pivot_of(const std::vector<Stand>& stands, Id active, Pivot pivot,
                    const Box& seen_world);
glm::dmat3 shared_axes(const std::vector<Stand>& stands, Id active, Orientation orientation,
                       const Camera& camera);

// A Grasp says how a gesture begins: on a handle, or by its key.
struct Grasp {
    glm::dvec3 pivot_world{0};
    GizmoHandle handle = {};
    glm::dvec2 from_px{0};
    double scale = 1;      // of the interface
    bool own_axes = false; // no other axes can be chosen, and a turn is about that of the handle
};

// A TransformGesture is moving, turning or scaling by hand, from beginning to end, without anything
// that shows it: the way of the mouse, the chosen axes and the typed numbers give a motion.
class TransformGesture {
public:
    TransformGesture(MotionKind kind, std::vector<Stand> stands, Id active,
                     const TransformChoices& choices, const Camera& camera, const Grasp& grasp);

    struct HeldKeys {
        bool snap = false, fine = false;
    };
    // Follows the hand; where the camera moved instead, only the place of the mouse changes.
    void move_hand(const Camera& camera, glm::dvec2 to_px, HeldKeys held);
    // Chooses an axis by its key: first that axis; pressed again, that of the other orientation,
    // where there is a choice; pressed once more, none.
    void choose_axis(int axis, bool plane);
    TypedAmounts& typed() { return typed_; }
    const TypedAmounts& typed() const { return typed_; }
    // number of values that can be typed
    int numbers() const { return static_cast<int>(named_axes().size()); }

    MotionKind kind() const { return kind_; }
    Motion motion() const;
    std::vector<Id> ids() const;
    std::vector<Transform> transforms() const;
    std::string words() const;  // "Move X 1.25 m"
    std::string amount() const; // "X 1.25 m"

    const GizmoHandle& constraint() const { return constraint_; } // none: free
    MotionFrame frame() const; // of the handles, at the beginning
    glm::dvec3 turn_axis_world() const;
    bool free() const; // the hand may go anywhere, and no number is typed
    double travelled_px() const { return travelled_px_; }
    glm::dvec2 from_px() const { return from_px_; }

private:
    bool about_view() const; // a turn without an axis is about the line of sight
    std::vector<int> named_axes() const;
    glm::dvec3 offset_by_hand() const; // in the world, before any snapping, like the next two
    double factor_by_hand() const;
    double turned_deg(glm::dvec2 from_px, glm::dvec2 to_px) const;
    Motion by_hand() const;
    Motion by_numbers() const;
    double snapped(double amount) const;
    std::string amount_of(int number, double value) const;

    MotionKind kind_;
    std::vector<Stand> stands_;
    Id active_;
    TransformChoices choices_;
    Orientation asked_; // of the options bar, while a key chose the other one
    Camera camera_;
    glm::dvec3 pivot_world_;
    GizmoHandle constraint_;
    bool by_handle_, own_axes_;
    double scale_;
    glm::dvec2 from_px_, hand_px_, mouse_px_; // the hand goes slower than the mouse while fine
    glm::dvec3 offset_before_{0};             // done before the camera moved, in the world
    double factor_before_ = 1, turned_deg_ = 0, travelled_px_ = 0;
    HeldKeys held_;
    TypedAmounts typed_;
};

} // namespace trivar
