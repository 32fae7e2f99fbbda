// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/dice.h"

#include <string>
#include <vector>

namespace trivar::testing {

// The bytes with one to three of these done to them: some bytes or bits changed, a run of 0 or of
// 255, cut off, a stretch doubled or left out, a number replaced by an extreme one (as text or as
// four bytes), joined with one of `others`, of the same kind.
std::string with_bytes_damaged(std::string bytes, const std::vector<std::string>& others,
                               Dice& dice);

} // namespace trivar::testing
