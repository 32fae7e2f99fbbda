// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace trivar {

// Names that actions had before, with those that they have now. Preferences keep the keys that a
// person gave to an action by its name.
const std::vector<std::pair<std::string_view, std::string_view>>& renamed_actions();

// Returns the present name of an action that once had this name; the same if it was never renamed.
std::string_view present_action(std::string_view name);

} // namespace trivar
