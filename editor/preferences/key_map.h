// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

// A KeyMap holds the keys that a person gave to actions in place of the usual ones, by the action's
// name.
using KeyMap = std::map<std::string, std::vector<ui::Chord>>;

} // namespace trivar
