// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

// An Adjustment is the last step, whose numbers can still be changed: a change takes the step back
// and makes another in its place.
struct Adjustment {
    bool open = false;             // the card shows the numbers
    std::size_t step = 0;          // number of steps in force after it; 0: there is none
    std::size_t seen = 0;          // steps in force in the last frame
    bool known = false;            // `seen` is of this scene
    bool running = false;          // a hand is on a number
    std::vector<Id> selected = {}; // the selection before the step
    float height_px = 0;           // of the card's rows
};

// Whether a step of this kind has numbers that are worth changing.
bool can_be_adjusted(const Command& command);

// Takes note of a step that was just made, and forgets it when something else happens.
void follow_steps(Adjustment& adjustment, const Session& session);

// Shows the scene as if the step had been this one.
void propose_instead(Adjustment& adjustment, Session& session, const Command& command);
// Commits the change, or brings the step back.
void finish_adjusting(Adjustment& adjustment, Session& session, bool cancelled);

// The last step's command, for the objects that are selected now; empty where that makes no sense.
std::optional<Command> repeated(const Session& session);

} // namespace trivar
