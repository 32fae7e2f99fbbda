// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/words_with_keys.h"

#include <string>

namespace trivar::testing {

// The names after @ that no action has: what with_keys() leaves as it is.
inline std::vector<std::string> unknown_actions(const Editor& editor, const std::string& text)
{
    std::vector<std::string> unknown;
    for (const ui::Run& run : with_keys(editor, {{ui::Run::Kind::plain, text}}))
        for (std::size_t at = 0; (at = run.text.find('@', at)) != run.text.npos; ++at)
            unknown.emplace_back(
                run.text.substr(at + 1, run.text.find_first_of(" .,;)", at) - at - 1));
    return unknown;
}

} // namespace trivar::testing
