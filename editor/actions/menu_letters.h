// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// For each name a letter by which it is chosen: the first of its letters that is not used by an
// earlier name and not `taken`, as a capital; 0 where no letter is left.
std::vector<char> menu_letters(const std::vector<std::string>& names, std::string_view taken = {});

} // namespace trivar
