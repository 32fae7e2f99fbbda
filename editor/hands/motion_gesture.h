// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/gesture.h"
#include "editor/hands/tool.h"
#include "editor/hands/transform_gesture.h"

namespace trivar {

// A MotionGesture is a gesture that moves, turns or scales: with the mouse, along axes that keys
// choose, or by typed numbers.
class MotionGesture : public GestureWith<TransformGesture> {
public:
    using GestureWith::begin;
    // Begins the motion of an object that stands in a frame, in the world, along its own
    // directions. Without a handle a key began it.
    void begin(MotionKind kind, Id object, const MotionFrame& stands, const GizmoHandle& handle,
               const Camera& camera, const ViewportInput& input);
    // Returns whether it is more than a click: the hand went further, or a key began it, or a
    // number is typed.
    bool meant() const;
    // `wanted` is asked where the motion is more than nothing.
    State go_on(Session& session, const ViewportInput& input, const Wanted& wanted,
                const Commit& commit = {});
    State finish(Session& session, const Wanted& wanted, const Commit& commit = {});
    // Takes the keys of a frame: X, Y, Z choose an axis (with Shift its plane), digits are typed,
    // Tab goes to the next number. Whether they end it.
    bool take_keys();
    bool types_formula() const; // letters belong to it then
    // While it goes on; `axes`: what X, Y and Z choose.
    std::vector<Hint> hints(const char* axes) const;

private:
    Wanted more_than_nothing(const Wanted& wanted) const;
};

// Says that no control point is selected, to one who struck G, R or S.
void say_no_point_is_selected(Session& session);

} // namespace trivar
