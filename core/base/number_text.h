// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

// Numbers as people read them: in sentences, titles and fields.

namespace trivar {

// How a number is written.
struct NumberForm {
    int digits = 3;     // significant ones; all those before the point are written as well
    int decimals = 0;   // written at least, where `digits` reaches so far: 0.40 beside 0.42
    bool commas = true; // between thousands
};

// A number rounded to its form: "0.0247", "1,800", "-3.5". It is never "-0", and "0" only for 0.
// Sizes outside 1e-9 to 1e15 have a power of ten, "2.4·10⁻¹⁷", no other number has. What is not
// finite is "infinite" or "no number".
std::string number_text(double value, NumberForm form = {});

std::string with_commas(std::uint64_t count); // "262,144"

// A share as per cent, to two digits at least: "0.41 %", "110 %".
std::string percent_text(double share);

} // namespace trivar
