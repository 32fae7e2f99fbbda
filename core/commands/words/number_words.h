// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/parameters.h"

#include <string>

namespace trivar {

// NumberWords says how a parameter is named and shown, in the words of the panels: "Position Z", in
// metres. The shown number is the value times a factor: angles are in degrees.
struct NumberWords {
    std::string label, unit;
    double factor = 1;
};
NumberWords words_of_number(const std::string& parameter);

// A value of a parameter with its unit: "0.24 m", "7", "on", "Wood".
std::string words_of_value(const Parameter& parameter, double value);

} // namespace trivar
