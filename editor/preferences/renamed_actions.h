// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace trivar {

// Names that actions had before, with those that they have now. Preferences keep the keys that a
// person gave to an action by its name.
const std::vector<std::pair<std::string_view, std::string_view>>& renamed_actions();

// What an action is called now that was called so before; the same where it is called so still.
std::string_view present_action(std::string_view name);

} // namespace trivar
