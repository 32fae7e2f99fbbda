// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

namespace trivar {

void add_split_actions(std::vector<Action>& actions);

} // namespace trivar
