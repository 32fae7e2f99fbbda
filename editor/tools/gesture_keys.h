// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/gesture.h"

namespace trivar {

// What is struck while a gesture runs: X, Y, Z choose an axis (with Shift its plane), digits are
// typed, Tab goes to the next number. Whether Enter ended it.
bool take_gesture_keys(TransformGesture& gesture);

} // namespace trivar
