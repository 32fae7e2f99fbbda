// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"
#include "ui/paint.h"

namespace trivar::ui {

// A Splitter is the line between two panels, to be dragged: 1 px to see, 6 px to grip. It lies over
// the panels when it is drawn before them.
struct Splitter {
    bool dragged = false, restored = false; // restored: it was double-clicked
    float at = 0; // while dragged: the wanted place of the line, in pixels
};
Splitter splitter(Frame& frame, const char* name, const Rect& line);

} // namespace trivar::ui
