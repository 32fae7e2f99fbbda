// SPDX-License-Identifier: GPL-3.0-or-later
// `trivar bench gpu` alone, for machines that have a graphics card and little else.
#include "core/base/rejected.h"
#include "editor/command_line/bench.h"

#include <iostream>
#include <string_view>
#include <unistd.h>

int main(int count, char** arguments)
{
    trivar::BenchOptions options;
    options.json = count > 1 && std::string_view(arguments[1]) == "--json";
    const trivar::Streams streams{std::cout, std::cerr, isatty(STDERR_FILENO) == 1};
    try {
        return static_cast<int>(trivar::run_bench(options, streams));
    } catch (const trivar::Rejected& error) {
        std::cerr << "trivar: " << error.what() << "\n";
        return static_cast<int>(trivar::Status::rejected);
    }
}
