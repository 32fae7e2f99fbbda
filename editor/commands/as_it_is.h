// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <vector>

namespace trivar {

// The command of that kind that would leave the object as it is, for kinds that say something as a
// whole: a transform, a material, how it lies and travels, its file, and picture and time of no
// object. Nothing for other kinds, and where the object has no such thing.
std::optional<Command> as_it_is(const Command& kind, Id object, const Document& document);

// The command about those objects; of one that takes one object, about the last. What it adds looks
// as new things do.
Command about(Command command, const std::vector<Id>& objects);
bool is_about_objects(const Command& command);

} // namespace trivar
