// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"
#include "editor/timeline/key_target.h"

namespace trivar {

inline constexpr const char *insert_key_action = "Insert key", *remove_key_action = "Remove key",
                            *next_key_action = "Next key", *previous_key_action = "Previous key",
                            *auto_key_action = "Auto-key";

// Adds the actions of the menu Animate that work on keys.
void add_key_actions(std::vector<Action>& actions);
// Makes the actions that choose, delete, copy, move, scale and frame work on keys, by whichever
// keyboard keys they have, while the mouse is over the open timeline.
void let_keys_take(std::vector<Action>& actions);

// Returns the numbers of a kept view that can be animated: its position, its target and its angle.
std::vector<std::string> names_of_view(const std::string& view);

// Opens the timeline with these tracks chosen.
void show_tracks(Editor& editor, const KeyTarget& target);

} // namespace trivar
