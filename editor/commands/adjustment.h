// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

// The step that was made last, whose numbers can still be changed: doing so takes it back and makes
// another in its place.
struct Adjustment {
    bool open = false;             // the card shows the numbers
    std::size_t step = 0;          // it is the one after which so many are in force; 0: none
    std::size_t seen = 0;          // steps in force in the last frame
    bool known = false;            // `seen` is of this scene
    bool running = false;          // a hand is on a number
    std::vector<Id> selected = {}; // before it was
    float height_px = 0;           // of the card's rows
};

// Whether a step of this kind has numbers worth another look.
bool can_be_adjusted(const Command& command);

// Takes note of a step that was just made, and forgets it when something else happens.
void follow_steps(Adjustment& adjustment, const Session& session);

// Shows the scene as if the step had been this one.
void propose_instead(Adjustment& adjustment, Session& session, const Command& command);
// Makes it so, or brings the step back.
void finish_adjusting(Adjustment& adjustment, Session& session, bool cancelled);

// What the last step did, for the objects that are selected now; nothing where that has no sense.
std::optional<Command> repeated(const Session& session);

} // namespace trivar
