// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// Presses the button of a notice that has these words.
inline void press_button(Editor& editor, const std::string& words)
{
    const std::vector<ui::Notices::Notice> all = editor.session.notices.all();
    for (const auto& each : all)
        for (const auto& action : each.actions)
            if (action.words == words) return action.act();
    ADD_FAILURE() << "no button " << words;
}

} // namespace trivar::testing
