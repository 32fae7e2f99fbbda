// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "editor/actions/actions.h"

namespace trivar {

// Adds undo and redo, and the edits of the selected objects.
void add_edit_actions(std::vector<Action>& actions);
// Attaches a placed object to its hosts, or says why not.
void attach_as_it_lies(Editor& editor, Id id);

} // namespace trivar
