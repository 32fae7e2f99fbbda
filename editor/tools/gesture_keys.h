// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/gesture.h"

namespace trivar {

// Takes the keys that are struck while a gesture runs: X, Y, Z choose an axis (with Shift its
// plane), digits are typed, Tab goes to the next number. Returns whether Enter ended the gesture.
bool take_gesture_keys(TransformGesture& gesture);

} // namespace trivar
