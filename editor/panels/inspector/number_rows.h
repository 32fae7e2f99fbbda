// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/parameters.h"

#include <string>
#include <vector>

namespace trivar {

// The section of the inspector that shows them.
inline constexpr const char* number_rows_title = "Other animatable properties";

// A NumberRow is a number of an object that no command sets alone, but keys do, as a row of the
// inspector.
struct NumberRow {
    std::string caption; // of the step of shaping that begins here; else empty
    std::string label;   // within its step: "Move X"
    Parameter number;
};
// Sizes that a primitive was made with and numbers of steps of shaping, at most so many. Numbers of
// each point of a gesture are left out.
std::vector<NumberRow> number_rows(const Object& object, std::size_t most);

} // namespace trivar
