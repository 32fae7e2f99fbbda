// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/commands/command_form.h"

namespace trivar {

struct Editor;

// Values are filled in one field after another and shown in the picture as they are. Nothing is
// done till it runs, as one step.
void begin_filling(Editor& editor, CommandForm form);
void show_filling(Editor& editor); // after a change of the form
// To the field that follows or comes before; it stays where the value at hand is refused. False:
// there is none before.
bool next_field(Editor& editor, int step);
bool run_filled(Editor& editor); // false: refused, and the form says why
void leave_filling(Editor& editor);

} // namespace trivar
