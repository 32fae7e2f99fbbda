// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"

namespace trivar {

// The section of the inspector by which an object is drawn in lines.
void draw_line_drawing(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
