// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <optional>

namespace trivar {

// When an object moves, in frames; `endless`: `end` is past the last frame.
struct TravelBar {
    double begin = 0, end = 0;
    bool endless = false;
};
// Returns the bar; nothing if the object is hidden and so was not evaluated.
std::optional<TravelBar> bar_of(const Session& session, Id id);

// The frames of the scene with as many whole seconds more as let everything that comes to an end
// come there; nothing where it does already.
std::optional<Time> time_with_room(const Session& session);

} // namespace trivar
