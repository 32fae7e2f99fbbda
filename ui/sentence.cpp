// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sentence.h"

#include <utility>

namespace trivar::ui {

std::string capitalised(std::string text)
{
    const bool name = text.substr(0, text.find(' ')).find_first_of("./_") != std::string::npos;
    if (!name && !text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string sentence(std::string text)
{
    if (text.empty()) return text;
    if (text.find_last_of(".!?") != text.size() - 1) text += '.';
    return capitalised(std::move(text));
}

} // namespace trivar::ui
