// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A word that artists know from other programs, and the names under which the palette has what they
// look for: of actions and commands, as they are listed there.
struct Synonym {
    std::string_view word;
    std::vector<std::string_view> names;
};
const std::vector<Synonym>& synonyms();

// The names for all words of the table that begin with what is typed, whatever its case; the best
// known first. Nothing for fewer than two letters.
std::vector<std::string> names_meant_by(std::string_view typed);

} // namespace trivar
