// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/dice.h"

#include <string>

namespace trivar::testing {

// The JSON text with one or two of its values, whole lists and objects too, replaced: by an extreme
// number, a near one, an empty or odd text, null, an empty list or object, what is nested deep, a
// small index, a copy of another value of the text; two of them exchanged; or one left out.
std::string with_values_replaced(const std::string& json, Dice& dice);

} // namespace trivar::testing
