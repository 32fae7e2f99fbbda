// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/peak_memory.h"

#include <fstream>
#include <malloc.h>
#include <string>

namespace trivar::testing {

void forget_peak_memory()
{
    malloc_trim(0); // what the last case freed is not this one's
    std::ofstream("/proc/self/clear_refs") << "5";
}

std::optional<std::size_t> peak_memory()
{
    if (TRIVAR_SANITIZED) return {};
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (std::size_t kib = 0; word == "VmHWM:" && status >> kib) return kib * 1024;
    return {};
}

} // namespace trivar::testing
