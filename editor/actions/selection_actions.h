// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Adds the actions that change the selection or how it is shown: all, none, the others, of one
// type.
void add_selection_actions(std::vector<Action>& actions);

} // namespace trivar
