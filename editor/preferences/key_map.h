// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

// The keys of the actions that a person gave other keys than the usual ones, by name.
using KeyMap = std::map<std::string, std::vector<ui::Chord>>;

} // namespace trivar
