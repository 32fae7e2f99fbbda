// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// The manual, the start card, finding commands, and the steps of a tutorial.
void add_help_actions(std::vector<Action>& actions);

inline constexpr const char *tutorial_next = "Next step", *tutorial_back = "Step back",
                            *tutorial_close = "Close the tutorial";

inline constexpr const char* show_hints_action = "Show hints again";

// Each of these scenes can be begun as a tutorial from now on.
void add_tutorials(Editor& editor, const std::vector<std::string>& paths);
// Each of the samples can be opened by its name from now on.
void add_samples(Editor& editor);
bool has_tour(const Editor& editor);
void begin_tour(Editor& editor); // the first of them

} // namespace trivar
