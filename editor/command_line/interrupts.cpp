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
    waits_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts()
{
    over_ = true;
    pthread_kill(waits_.native_handle(), SIGTERM); // for that thread alone
    waits_.join();
    const timespec at_once{};
    while (sigtimedwait(&waiting_, nullptr, &at_once) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupts::wait()
{
    for (int signal = 0; sigwait(&waiting_, &signal) == 0 && !over_;) {
        if (!came_.exchange(true)) continue;
        raise(signal); // and now it does what it would do
        pthread_sigmask(SIG_UNBLOCK, &waiting_, nullptr);
        pthread_sigmask(SIG_BLOCK, &waiting_, nullptr);
    }
}

} // namespace trivar
