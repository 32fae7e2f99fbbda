// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar {

// A share as per cent, for shares that may be tiny or more than the whole: two digits at least, and
// no powers of ten. "0.41 %", "110 %", "under 0.01 %".
std::string share_words(double share);

} // namespace trivar
