// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A Synonym is a word that artists know from other programs, with the names of the actions and
// commands that it means, as the palette lists them.
struct Synonym {
    std::string_view word;
    std::vector<std::string_view> names;
};
const std::vector<Synonym>& synonyms();

// The names for all words of the table that begin with what is typed, whatever its case; the best
// known first. Nothing for fewer than two letters.
std::vector<std::string> names_meant_by(std::string_view typed);

} // namespace trivar
