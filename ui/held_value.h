// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

namespace trivar::ui {

// Handles what all fields share whose values are dragged in a picture; it is called after the
// picture's button and the drag. A click may hold the mouse button on; after a double click that
// dragged nothing the next number field takes what is typed; Esc ends the drag. `edit` is what the
// drag did, `held` says that a value is in the hand. Returns what becomes of the edit.
Edit after_drag(Edit edit, bool held);

} // namespace trivar::ui
