// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

// Puts a lattice round what is selected, and takes the tool that moves its points.
void add_lattice_actions(std::vector<Action>& actions);

} // namespace trivar
