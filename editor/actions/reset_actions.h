// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Position, rotation or scale of the selected objects as they were when they were new.
void add_reset_actions(std::vector<Action>& actions);

} // namespace trivar
