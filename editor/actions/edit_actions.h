// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "editor/actions/actions.h"

namespace trivar {

// Undo and what is done to the selected objects.
void add_edit_actions(std::vector<Action>& actions);
// Attaches a placed object to what it lies on, or says why not.
void attach_as_it_lies(Editor& editor, Id id);

} // namespace trivar
