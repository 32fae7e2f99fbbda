// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace trivar {

// A Measure is the quantity of a typed number: it decides which units the number may carry, and the
// unit of the result.
enum class Measure {
    plain,  // no unit
    length, // mm cm m km in ft; metres
    angle   // deg rad; degrees
};

// The value of a number as people type it: "1.25", "3 * (2 + 1)", "-2^2", "12 mm + 0.5 in",
// "sqrt(2)", "max(1, pi)", "2.4·10⁻¹⁷".
// Functions take and give the field's own number: sin(30) of an angle is 0.5. A leading "+=", "-=",
// "*=" or "/=" changes `present`; a plain "=" is ignored. Empty where the text cannot be read or
// the result is not finite.
std::optional<double> evaluate_expression(std::string_view text, Measure measure,
                                          double present = 0);

} // namespace trivar
