// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The letters of a text by their Unicode numbers. Throws Rejected for bytes that are not UTF-8.
std::u32string letters_of(std::string_view utf8);
std::string utf8_of(char32_t letter);

bool is_control(char32_t letter); // Unicode's category Cc
bool is_blank(char32_t letter);   // a space of any width, also of width 0
// Whether a letter is a joiner, a variation selector or a mark of direction: nothing is drawn where
// a font lacks it.
bool is_ignorable(char32_t letter); // Unicode's Default_Ignorable_Code_Point, as shapers take it

// The lines of a text without their line breaks (CR, LF, both, and Unicode's own two); tabs become
// four spaces.
std::vector<std::u32string> lines_of(std::u32string_view letters);

} // namespace trivar
