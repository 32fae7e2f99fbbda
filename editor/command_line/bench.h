// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"

#include <string>

namespace trivar {

struct BenchOptions {
    std::string what; // "gpu"
    bool json = false;
    int vertices = 10'000'000; // no case has more
    double most_s = 1;         // for one run of a case
    double minutes = 8;        // no case begins later
};

// trivar bench. Throws Rejected where there is no OpenGL.
Status run_bench(const BenchOptions& options, const Streams& streams);

} // namespace trivar
