// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/transform_gesture.h"
#include "editor/session/session.h"

namespace trivar {

// Takes the keys that are struck while a gesture runs: X, Y, Z choose an axis (with Shift its
// plane), digits are typed, Tab goes to the next number. Returns whether Enter ended the gesture,
// or, of one that a key began, a click while the mouse is outside of the viewport: then it ends
// before the panel there sees the click.
bool take_gesture_keys(TransformGesture& gesture, bool begun_by_key, bool outside);

// Says that no control point is selected, to one who struck G, R or S.
void say_no_point_is_selected(Session& session);

} // namespace trivar
