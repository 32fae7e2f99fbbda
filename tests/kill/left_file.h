// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kill/watched_program.h"

#include <string>

// Checks the file that a killed window left on the disk.

namespace trivar::testing {

// Whether the text of a scene's file, by as many lines as were shown, comes to the steps that were.
// Throws Rejected where it cannot be read whole, for a last line that is torn too.
bool holds(const std::string& text, const Shown& shown);

// The file of the latest scene without a name that has steps; empty: there is none. Locks nothing.
std::string latest_kept(const std::string& folder);

} // namespace trivar::testing
