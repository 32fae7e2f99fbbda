// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "editor/command_line/command_line.h"

#include <csignal>
#include <iostream>
#include <unistd.h>

int main(int count, char** arguments)
{
    trivar::keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN); // a file that may grow no further is said, as a full disk is
    const trivar::Streams streams{std::cout, std::cerr, isatty(STDERR_FILENO) == 1};
    const trivar::Status status = trivar::run_program({arguments + 1, arguments + count}, streams);
    std::cout.flush();
    // A full disk or a closed pipe swallowed results.
    return static_cast<int>(std::cout.good() ? status : trivar::Status::rejected);
}
