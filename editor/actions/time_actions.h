// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

inline constexpr const char *play_action = "Play or pause", *next_frame_action = "Next frame",
                            *previous_frame_action = "Previous frame",
                            *first_frame_action = "First frame", *last_frame_action = "Last frame",
                            *loop_action = "Play in a loop", *timeline_action = "Timeline",
                            *make_room_action = "Extend range to fit motion";

// Adds the actions of the menu Animate.
void add_time_actions(std::vector<Action>& actions);

} // namespace trivar
