// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Letters by their Unicode numbers. Throws Rejected for bytes that are no UTF-8.
std::u32string letters_of(std::string_view utf8);
std::string utf8_of(char32_t letter);

bool is_control(char32_t letter); // Unicode's category Cc
bool is_blank(char32_t letter);   // a space of any width, also of none
// Joiners, variation selectors, marks of direction: nothing is drawn where a font lacks them.
bool is_ignorable(char32_t letter); // Unicode's Default_Ignorable_Code_Point, as shapers take it

// Without their line breaks (CR, LF, both, and Unicode's own two); tabs are four spaces.
std::vector<std::u32string> lines_of(std::u32string_view letters);

} // namespace trivar
