// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar::testing {

// Does something in a process of its own, which is then killed.
template <class Work> void die_with(Work&& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

} // namespace trivar::testing
