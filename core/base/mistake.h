// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace trivar {

// Mistake reports a fault of Trivar itself: an assumption of its code does not hold. The user's
// data are not to blame. Tests stop at it; the window shows the object without the step that
// failed, and goes on.
struct Mistake : std::logic_error {
    using logic_error::logic_error;
};
[[noreturn]] void mistaken(const char* wrong, const char* file, int line);

// Throws Mistake, with these words and the place of the call, unless the assumption `holds`. The
// place is not a std::source_location, which clang 14 does not have.
inline void ensure(bool holds, const char* wrong, const char* file = __builtin_FILE(),
                   int line = __builtin_LINE())
{
    if (!holds) mistaken(wrong, file, line);
}

// Whether an exception says that Trivar is wrong: all do except Rejected, Cancelled, and those of
// memory and of the system.
bool is_mistake(const std::exception& trouble);

// The words for the user of any exception, without a full stop.
std::string words_of(const std::exception& trouble);

} // namespace trivar
