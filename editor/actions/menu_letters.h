// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// For each name a letter of its own by which it is chosen: the first of its letters that no name
// before it has and that is not `taken`, a capital; 0 where none is left.
std::vector<char> menu_letters(const std::vector<std::string>& names, std::string_view taken = {});

} // namespace trivar
