// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"
#include "editor/preferences/key_map.h"

#include <string>
#include <vector>

namespace trivar {

// The keys that differ from the usual ones, by action.
KeyMap changed_keys(const std::vector<Action>& actions);
void use_keys(std::vector<Action>& actions, const KeyMap& map); // all others get their usual ones

// Gives the action this key in place of its keys. A key belongs to one action: returns the names of
// those that lost it.
std::vector<std::string> give_key(std::vector<Action>& actions, const std::string& name,
                                  const ui::Chord& chord);
std::vector<std::string> give_usual_keys(std::vector<Action>& actions, const std::string& name);

// Opens the key map, which waits for the new key of this action.
void ask_for_key(Editor& editor, const std::string& action);

} // namespace trivar
