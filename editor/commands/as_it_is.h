// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <vector>

namespace trivar {

// The command of that kind that would change nothing of the object, for kinds that set something as
// a whole: a transform, a material, how it lies and travels, its file (as_it_is() of the command,
// or `sets`, the member of an object that it gives to its objects); and picture and time, without
// an object. Empty for other kinds, and where the object has no such thing.
std::optional<Command> as_it_is(const Command& kind, Id object, const Document& document);

// The command with these objects; a command that takes one object gets the last. New objects look
// as new things do.
Command about(Command command, const std::vector<Id>& objects);
bool is_about_objects(const Command& command);

} // namespace trivar
