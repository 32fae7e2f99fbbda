// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/commands/command_form.h"

namespace trivar {

struct Editor;

// Begins to fill in a command: values are filled in one field after another, and the picture shows
// them. Nothing is done until it runs, as one step.
void begin_filling(Editor& editor, CommandForm form);
void show_filling(Editor& editor); // after a change of the form
// Goes to the next or the previous field; stays where the current value is refused. False: there is
// no previous field.
bool next_field(Editor& editor, int step);
bool run_filled(Editor& editor); // false: refused, and the form says why
void leave_filling(Editor& editor);

} // namespace trivar
