// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

inline constexpr const char* plain_copy_action = "Copy as plain mesh...";
inline constexpr const char* apply_shape_action = "Apply shape...";

inline constexpr const char* place_round_action = "Place round";
inline constexpr const char* cover_action = "Cover with tiles";

// Lays what is selected round a body, and makes what was laid final.
void add_placement_actions(std::vector<Action>& actions);

} // namespace trivar
