// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

#include <string>
#include <string_view>

// How fields and their values are said to a person, by what the lists of fields say of them.

namespace trivar {

// A field's name as words: "fill_gap" is "Fill gap", "rotation_deg" is "Rotation".
std::string in_words(std::string_view name);
// What panels and the history call a field.
std::string label_of(std::string_view name, const Rule& rule);
// "m", "deg", "s", "m/s" and so on; empty: the number has no unit.
std::string unit_text(Unit unit);
// What is shown of a number is this many times what is stored.
double shown_factor(Unit unit);
// What the component of a vector is called: "Z", "V", "green".
std::string axis_of(const Rule& rule, int component);

// Three significant digits, no trailing zeros: "0.24", "12.3", "4".
std::string brief_number(double value);
std::string in_metres(double value);
std::string in_degrees(double value);
// With its unit, as the unit is said in a sentence: "0.24 m", "90°", "1 stop", "at frame 24".
std::string with_unit(double value, Unit unit);

} // namespace trivar
