// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

// Shades the selection smooth, by angle, flat or as its files have it; unwraps it, and gives it the
// UVs of its files back.
void add_surface_actions(std::vector<Action>& actions);

} // namespace trivar
