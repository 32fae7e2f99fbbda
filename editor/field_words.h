// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/number_words.h"

#include <string>
#include <string_view>

namespace trivar {

// "m", "deg", "rad", "s", "m/s" or nothing, by the field's name and what its help says of it.
std::string unit_of_field(std::string_view name, std::string_view help);
// What a field of a command means, as docs/commands.md has it, to be shown beside a field that
// has the unit in it: of "edit_placement" and "parameters.width".
std::string help_of_field(const std::string& verb, const std::string& name);

} // namespace trivar
