// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/letters.h"

#include "core/base/rejected.h"
#include "core/base/utf8.h"

namespace trivar {

std::u32string letters_of(std::string_view utf8)
{
    std::u32string letters;
    while (!utf8.empty()) {
        const Utf8Letter next = first_letter(utf8);
        if (next.bytes == 0) throw Rejected("the text is not UTF-8");
        letters += next.number;
        utf8.remove_prefix(next.bytes);
    }
    return letters;
}

std::string utf8_of(char32_t letter)
{
    std::string text;
    const auto tail = [&](int bits) {
        text += static_cast<char>(0x80 | ((letter >> bits) & 0x3F));
    };
    if (letter < 0x80) {
        text += static_cast<char>(letter);
    } else if (letter < 0x800) {
        text += static_cast<char>(0xC0 | (letter >> 6));
    } else if (letter < 0x10000) {
        text += static_cast<char>(0xE0 | (letter >> 12));
        tail(6);
    } else {
        text += static_cast<char>(0xF0 | (letter >> 18));
        tail(12);
        tail(6);
    }
    if (letter >= 0x80) tail(0);
    return text;
}

bool is_control(char32_t letter)
{
    return letter < 0x20 || (letter >= 0x7F && letter < 0xA0);
}

bool is_blank(char32_t letter)
{
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r' || letter == 0xA0 ||
           letter == 0xAD || letter == 0x61C || letter == 0x1680 ||
           (letter >= 0x2000 && letter <= 0x200F) || (letter >= 0x2028 && letter <= 0x202F) ||
           (letter >= 0x205F && letter <= 0x206F) || letter == 0x3000 || letter == 0xFEFF;
}

bool is_ignorable(char32_t letter)
{
    return letter == 0xAD || letter == 0x34F || letter == 0x61C || letter == 0x17B4 ||
           letter == 0x17B5 || (letter >= 0x180B && letter <= 0x180E) ||
           (letter >= 0x200B && letter <= 0x200F) || (letter >= 0x202A && letter <= 0x202E) ||
           (letter >= 0x2060 && letter <= 0x206F) || (letter >= 0xFE00 && letter <= 0xFE0F) ||
           letter == 0xFEFF || (letter >= 0xFFF0 && letter <= 0xFFF8) ||
           (letter >= 0x1D173 && letter <= 0x1D17A) || (letter >= 0xE0000 && letter <= 0xE0FFF);
}

std::vector<std::u32string> lines_of(std::u32string_view letters)
{
    std::vector<std::u32string> lines(1);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const char32_t letter = letters[i];
        if (letter == '\n' && i > 0 && letters[i - 1] == '\r') continue;
        if (letter == '\n' || letter == '\r' || letter == 0x2028 || letter == 0x2029)
            lines.emplace_back();
        else if (letter == '\t')
            lines.back() += U"    ";
        else
            lines.back() += letter;
    }
    return lines;
}

} // namespace trivar
