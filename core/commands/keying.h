// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

namespace trivar {

// What a hand does to something animated, said as keys in a frame. Where the command changes
// nothing but parameters of what was there, beside what the frame shows, and one of them has a
// track (or `always`), a command that keys all it changes; else the command itself. Throws what
// after() throws.
Command keyed(const Document& document, const Command& command, double frame, bool always);

// The animate command for keys of the present value, or without them for those in that frame. An
// object that has no such parameter is passed over; nothing where there is none.
std::optional<Command> keys_of(const Document& document, const std::vector<Id>& ids,
                               const std::vector<std::string>& names, double frame);
std::optional<Command> without_keys(const Document& document, const std::vector<Id>& ids,
                                    const std::vector<std::string>& names, double frame);

// Tracks of an object; id 0: of the scene.
const std::vector<Track>& tracks_of(const Document& document, Id id);
const Track* track_of(const Document& document, Id id, const std::string& parameter);
// Ids with tracks, the scene's 0 first.
std::vector<Id> animated_ids(const Document& document);

} // namespace trivar
