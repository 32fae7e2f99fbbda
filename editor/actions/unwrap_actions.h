// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

// Unwraps the selection, and gives it the UVs of its files back.
void add_unwrap_actions(std::vector<Action>& actions);

} // namespace trivar
