// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <vector>

namespace trivar {

std::vector<Action> all_actions();

} // namespace trivar
