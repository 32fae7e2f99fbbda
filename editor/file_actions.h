// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions.h"

namespace trivar {

// Scenes and models in and out.
void add_file_actions(std::vector<Action>& actions);

} // namespace trivar
