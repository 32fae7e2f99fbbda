// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Add the actions that change the view of the scene, and those that show, hide and scale parts of
// the window.
void add_view_actions(std::vector<Action>& actions);
void add_window_actions(std::vector<Action>& actions);

} // namespace trivar
