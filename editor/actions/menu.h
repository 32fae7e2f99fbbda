// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

namespace trivar {

// A Menu adds actions to a table of actions, under one title.
class Menu {
public:
    Menu(std::vector<Action>& actions, std::string title)
        : actions_(actions),
          title_(std::move(title))
    {
    }
    // Adds one with what an Action has of that name; what is set in the result besides is set in
    // the table.
    Action& operator()(std::string name, std::vector<ui::Chord> keys,
                       std::function<void(Editor&)> run, Condition enabled = {},
                       bool group_begins = false) const
    {
        actions_.push_back({title_, std::move(name), std::move(keys), std::move(run),
                            std::move(enabled), group_begins});
        return actions_.back();
    }

private:
    std::vector<Action>& actions_;
    std::string title_;
};

} // namespace trivar
