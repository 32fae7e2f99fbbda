// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keying.h"

#include <string>
#include <vector>

namespace trivar {

class Session;

// Numbers that keys are put on together, by hand.
struct KeyTarget {
    std::vector<Id> ids; // 0: the scene
    std::vector<std::string> names;
    bool empty() const { return ids.empty() || names.empty(); }
    bool operator==(const KeyTarget&) const = default;
};

// Those of its numbers that keys are meant for: where some have keys already, these alone.
KeyTarget meant_by(const Document& document, KeyTarget target);

// What the present frame is to them: no key anywhere, keys in others, or one of each that has any.
enum class KeyState { none, animated, here };
KeyState state_of_keys(const Session& session, const KeyTarget& target);

// Each a step: keys of the present values in the present frame, without those, without any. False
// where there is nothing to do.
bool insert_keys(Session& session, const KeyTarget& target);
bool remove_keys(Session& session, const KeyTarget& target);
bool remove_tracks(Session& session, const KeyTarget& target);
void toggle_keys(Session& session, const KeyTarget& target);

// The line of the log that gives them the keys they have; nothing without any.
std::optional<Command> tracks_command(const Document& document, const KeyTarget& target);

} // namespace trivar
