// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

namespace trivar {

// Exit statuses of the program.
enum class Status { done = 0, rejected = 1, usage = 2, check_failed = 3, interrupted = 130 };

// Streams say where a command of the program writes: results to `out` (the standard output), talk
// to `talk`.
struct Streams {
    std::ostream& out;
    std::ostream& talk;
    bool terminal = false; // talk is a terminal, so progress may be shown
};

} // namespace trivar
