// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keying.h"

#include <string>
#include <vector>

namespace trivar {

class Session;

// A KeyTarget is the numbers that get keys together, by hand.
struct KeyTarget {
    std::vector<Id> ids; // 0: the scene
    std::vector<std::string> names;
    bool empty() const { return ids.empty() || names.empty(); }
    bool operator==(const KeyTarget&) const = default;
};

// The numbers of the target that keys are meant for: where some have keys already, only these.
KeyTarget meant_by(const Document& document, KeyTarget target);

// The state of the present frame: no key anywhere; keys in other frames; or a key here for each
// number with keys.
enum class KeyState { none, animated, here };
KeyState state_of_keys(const Session& session, const KeyTarget& target);

// Keys as keys_of gives them for the present frame, but an automatic size gets a key of the shown
// value: a key of the 0 that stands for it would be a size of 0.
std::optional<Command> keys_as_shown(const Session& session, const std::vector<Id>& ids,
                                     const std::vector<std::string>& names);

// Each is one step: keys of the present values in the present frame; without these keys; without
// any. False where there is nothing to do.
// where there is nothing to do.
bool insert_keys(Session& session, const KeyTarget& target);
bool remove_keys(Session& session, const KeyTarget& target);
bool remove_tracks(Session& session, const KeyTarget& target);
void toggle_keys(Session& session, const KeyTarget& target);

// The line of the log that gives the numbers their present keys; empty without any.
std::optional<Command> tracks_command(const Document& document, const KeyTarget& target);

} // namespace trivar
