// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/menu_letters.h"

#include <cctype>

namespace trivar {

std::vector<char> menu_letters(const std::vector<std::string>& names, std::string_view taken)
{
    std::string gone(taken);
    std::vector<char> letters;
    for (const std::string& name : names) {
        letters.push_back(0);
        for (const char c : name) {
            const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            if (letter < 'A' || letter > 'Z' || gone.find(letter) != gone.npos) continue;
            gone += letters.back() = letter;
            break;
        }
    }
    return letters;
}

} // namespace trivar
