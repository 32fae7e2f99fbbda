// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

struct Action;

// The keys of the actions that a person gave other keys than the usual ones, by name.
using KeyMap = std::map<std::string, std::vector<ui::Chord>>;
KeyMap changed_keys(const std::vector<Action>& actions);
void use_keys(std::vector<Action>& actions, const KeyMap& map); // all others get their usual ones

// Gives the action this key instead of its keys. A key belongs to one action: the names of those
// that had it and lost it.
std::vector<std::string> give_key(std::vector<Action>& actions, const std::string& name,
                                  const ui::Chord& chord);
std::vector<std::string> give_usual_keys(std::vector<Action>& actions, const std::string& name);

} // namespace trivar
