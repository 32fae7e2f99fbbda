// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace trivar {

// A Utf8Letter is one letter of a text: its Unicode number and its number of bytes.
struct Utf8Letter {
    char32_t number = 0;
    std::size_t bytes = 0; // 0: the text continues with something that is not UTF-8
};

// The letter at the start of a text that is not empty. Overlong forms, surrogates and numbers above
// U+10FFFF are not UTF-8.
Utf8Letter first_letter(std::string_view text);

bool is_utf8(std::string_view text);

} // namespace trivar
