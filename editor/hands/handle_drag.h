// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/tool.h"

namespace trivar {

// Whether the hand wants round steps: Ctrl is held.
bool wants_round_steps();

// Follows the mouse with a handle in the hand: `drag` knows its camera and pixel at the beginning,
// and dragged(drag, pixel, snap) gives its command. What that makes is shown all the time; where
// the mouse lets go, commit(drag) makes it one step, if the mouse has moved by more than a click.
template <class Drag, class Commit>
void follow(std::optional<Drag>& drag, bool& moved, Session& session, const ViewportInput& input,
            const Commit& commit)
{
    drag->camera.size_px = session.view.camera.size_px;
    moved = moved || glm::distance(input.mouse, drag->from_px) > click_slip_px;
    const bool snap = wants_round_steps();
    if (input.released || !input.down) {
        const Drag done = *drag;
        drag.reset();
        if (moved && session.propose(dragged(done, input.mouse, snap)))
            commit(done);
        else
            session.cancel();
    } else if (moved && session.up_to_date()) {
        // One proposal at a time: the next waits until the last one can be seen.
        session.propose_quietly(dragged(*drag, input.mouse, snap));
    }
}

// Hints for a drag, or else for the handle under the mouse, of which `verb` says what it does.
std::vector<Hint> handle_hints(bool dragging, const char* verb);

} // namespace trivar
