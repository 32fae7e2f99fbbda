// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/number_text.h"
#include "core/document/field.h"

#include <string>
#include <string_view>

// These functions say fields and their values to a person, from what the lists of fields say of
// them.

namespace trivar {

// A field's name as words: "fill_gap" is "Fill gap", "rotation_deg" is "Rotation".
std::string in_words(std::string_view name);
// The name of a field in panels and in the history.
std::string label_of(std::string_view name, const Rule& rule);
// "m", "deg", "s", "m/s" and so on; empty: the number has no unit.
std::string unit_text(Unit unit);
// The factor from a stored number to the number that is shown.
double shown_factor(Unit unit);
// The name of a component of a vector: "Z", "V", "green".
std::string axis_of(const Rule& rule, int component);

std::string in_metres(double value);
std::string in_degrees(double value);
// A number with its unit, as the unit is said in a sentence: "0.24 m", "90°", "1 stop", "at frame
// 24".
std::string with_unit(double value, Unit unit);

} // namespace trivar
