// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

namespace trivar {

// Throws Rejected, naming the field, unless every number is finite and within its rule, every
// text is UTF-8 of sensible length and one of its choices, and no list is absurdly long. Knows
// nothing of documents.
void check(const Command& command);

} // namespace trivar
