// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/interrupts.h"

#include <ctime>

namespace trivar {

Interrupts::Interrupts()
{
    sigemptyset(&waiting_);
    sigaddset(&waiting_, SIGINT);
    sigaddset(&waiting_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &waiting_, &before_);
}

Interrupts::~Interrupts()
{
    const timespec at_once{};
    while (sigtimedwait(&waiting_, nullptr, &at_once) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool Interrupts::came() const
{
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

} // namespace trivar
