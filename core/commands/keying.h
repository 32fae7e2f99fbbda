// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

namespace trivar {

// Turns what a hand does to an animated object into keys in a frame. Where the command changes only
// parameters, compared with what the frame shows, and one of them has a track (or `always` is set),
// the result is a command that keys all changed parameters; else it is the command itself. Throws
// what after() throws.
Command keyed(const Document& document, const Command& command, double frame, bool always);

// The animate command that sets keys of the present value, or that removes the keys in that frame.
// Objects without such a parameter are skipped; empty where none has it.
std::optional<Command> keys_of(const Document& document, const std::vector<Id>& ids,
                               const std::vector<std::string>& names, double frame);
std::optional<Command> without_keys(const Document& document, const std::vector<Id>& ids,
                                    const std::vector<std::string>& names, double frame);

// The tracks of an object; for id 0 those of the scene.
const std::vector<Track>& tracks_of(const Document& document, Id id);
const Track* track_of(const Document& document, Id id, const std::string& parameter);
// The ids of objects with tracks; the scene's 0 comes first.
std::vector<Id> animated_ids(const Document& document);

} // namespace trivar
