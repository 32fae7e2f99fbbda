// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/utf8.h"

namespace trivar {

Utf8Letter first_letter(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80              ? 1
                               : (first & 0xE0u) == 0xC0 ? 2
                               : (first & 0xF0u) == 0xE0 ? 3
                               : (first & 0xF8u) == 0xF0 ? 4
                                                         : 0;
    if (length == 0 || length > text.size()) return {};
    char32_t letter = length == 1 ? first : first & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        const auto next = static_cast<unsigned char>(text[k]);
        if ((next & 0xC0u) != 0x80) return {};
        letter = (letter << 6) | (next & 0x3Fu);
    }
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = letter >= 0xD800 && letter < 0xE000;
    if (letter < least[length] || letter > 0x10FFFF || surrogate) return {};
    return {letter, length};
}

bool is_utf8(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t bytes = first_letter(text).bytes;
        if (bytes == 0) return false;
        text.remove_prefix(bytes);
    }
    return true;
}

} // namespace trivar
