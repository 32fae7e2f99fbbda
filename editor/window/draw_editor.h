// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"

namespace trivar {

struct Editor;

// Draws the whole window: takes input, runs keys, shows every panel.
void draw_editor(Editor& editor, ui::Frame& frame);

} // namespace trivar
