// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"
#include "ui/tooltip.h"

#include <string>
#include <vector>

namespace trivar {

Condition something_selected();
Condition something_there(); // in the scene

inline constexpr const char* add_action_name = "Add...";
inline constexpr const char* palette_action = "Find a command...";
inline constexpr const char* isolate_action = "Isolate";
inline constexpr const char* mend_action = "Repair folds";
inline constexpr const char* preferences_action = "Preferences...";

const Action& action(const Editor& editor, const std::string& name);
bool is_enabled(const Editor& editor, const Action& action);
std::string key_text(const Action& action); // "" without a key
// Returns the tooltip of its button: the sentence, and why it cannot be pressed.
ui::Tip tip_of(const Editor& editor, const Action& action, std::string sentence = {});

} // namespace trivar
