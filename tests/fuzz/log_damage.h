// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/dice.h"

#include <string>

namespace trivar::testing {

// A log with one to three of its lines damaged: a value in it replaced, left out, doubled,
// exchanged with another line, an undo or a redo before it, some of its bytes changed; or cut off
// in it.
std::string with_lines_damaged(const std::string& log, Dice& dice);

} // namespace trivar::testing
