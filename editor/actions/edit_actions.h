// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Undo and what is done to the selected objects.
void add_edit_actions(std::vector<Action>& actions);

} // namespace trivar
