// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

namespace trivar::ui {

// What all fields share whose values are dragged in a picture, asked for after the picture's button
// and the drag: its mouse button may be held on by a click, a double click that dragged nothing has
// the next number field take what is typed, Esc ends it. `edit` is what the drag did, `held` that
// it has a value in the hand; what became of the edit.
Edit after_drag(Edit edit, bool held);

} // namespace trivar::ui
