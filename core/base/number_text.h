// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

// Numbers as people read them: in sentences, titles and fields.

namespace trivar {

// A NumberForm says how a number is written.
struct NumberForm {
    // Significant ones; all those before the point are written as well. 0: as many as tell the
    // value from all others.
    int digits = 3;
    int decimals = 0;   // written at least, as far as three digits reach: 0.40 beside 0.42
    bool commas = true; // between thousands
    bool power = false; // of ten, whatever the size
};

// A number rounded to its form: "0.0247", "1,800", "-3.5". It is never "-0", and "0" only for 0.
// Only sizes outside 1e-9 to 1e16 have a power of ten: "2.4·10⁻¹⁷". What is not finite is
// "infinite" or "not a number".
std::string number_text(double value, NumberForm form = {});

std::string with_commas(std::uint64_t count); // "262,144"

// A share as per cent, to two digits at least: "0.41 %", "110 %", "under 0.01 %".
std::string percent_text(double share);

} // namespace trivar
