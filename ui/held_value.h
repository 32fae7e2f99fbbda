// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

namespace trivar::ui {

// Handles the part common to all fields whose values are dragged in a picture; it is called after
// the picture's button and the drag. A click may hold the mouse button on; after a double click
// that dragged nothing the next number field takes the typed text; Esc ends the drag.
//   edit  the effect of the drag
//   held  whether a value is in the hand
// Returns the resulting edit.
Edit after_drag(Edit edit, bool held);

} // namespace trivar::ui
