// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Returns a letter for each name by which it is chosen: the first of its letters that no earlier
// name uses and that is not `taken`, as a capital; 0 if no letter is left.
std::vector<char> menu_letters(const std::vector<std::string>& names, std::string_view taken = {});

} // namespace trivar
