// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Where the scene is looked at from; and what of the window is seen, and how large.
void add_view_actions(std::vector<Action>& actions);
void add_window_actions(std::vector<Action>& actions);

} // namespace trivar
