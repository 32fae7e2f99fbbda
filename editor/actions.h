// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <functional>
#include <string>
#include <vector>

namespace trivar {

struct Editor;

// Something that can be done from a menu or by a key. The one table of them makes menus, keys,
// tooltips and the list of keys in Help.
struct Action {
    std::string menu, name;
    std::vector<ui::Chord> keys; // the first is shown
    std::function<void(Editor&)> run;
    std::function<bool(const Editor&)> enabled = {}; // empty: always
    bool group_begins = false;                       // a rule above it in the menu
};

std::vector<Action> all_actions(const Editor& editor);

const Action& action(const Editor& editor, const std::string& name);
bool is_enabled(const Editor& editor, const Action& action);
std::string key_text(const Action& action); // "" without a key

// Runs the actions whose keys were struck in this frame.
void run_keys(Editor& editor);

} // namespace trivar
