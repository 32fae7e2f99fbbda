// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

inline constexpr const char* add_to_lattice_action = "Add to lattice";
inline constexpr const char* take_out_of_lattice_action = "Remove from lattice";
inline constexpr const char* keep_shape_action = "Delete lattice, keep shape";
inline constexpr const char* back_to_rest_action = "Delete lattice, back to rest";

// Adds the actions that put a lattice round the selection, take the tool that moves its points,
// take objects in and out, and delete it.
void add_lattice_actions(std::vector<Action>& actions);

} // namespace trivar
