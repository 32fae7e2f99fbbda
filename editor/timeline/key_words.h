// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar {

// How a number with keys is said and shown: "Position Z", in metres. What is shown is so many times
// the value: angles are in degrees.
struct NumberWords {
    std::string label, unit;
    double factor = 1;
};
NumberWords words_of_number(const std::string& parameter);

} // namespace trivar
