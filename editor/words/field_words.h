// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/field_words.h"

#include <string>
#include <string_view>

namespace trivar {

// A field's sentence without the unit that is shown beside its number.
std::string without_unit(std::string_view help);

// Returns the meaning of a field of a command as docs/commands.md tells it, for a place beside a
// field that shows the unit: for "edit_placement" and "parameters.width".
std::string help_of_field(const std::string& verb, const std::string& name);

} // namespace trivar
