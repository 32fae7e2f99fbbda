// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/interrupts.h"

#include <ctime>

namespace trivar {
namespace {

// A signal that is blocked is kept even where it is ignored.
bool is_ignored(int signal)
{
    struct sigaction now {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

} // namespace

Interrupts::Interrupts()
{
    sigemptyset(&waiting_);
    sigaddset(&waiting_, SIGUSR2); // that no more is to be waited for
    for (const int each : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(each)) sigaddset(&waiting_, each);
    pthread_sigmask(SIG_BLOCK, &waiting_, &before_);
    waits_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts()
{
    over_ = true;
    pthread_kill(waits_.native_handle(), SIGUSR2); // for that thread alone
    waits_.join();
    const timespec at_once{};
    while (sigtimedwait(&waiting_, nullptr, &at_once) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupts::wait()
{
    for (int signal = 0; sigwait(&waiting_, &signal) == 0 && !over_;) {
        if (signal == SIGUSR2 || !came_.exchange(true)) continue;
        raise(signal); // and now it does what it would do
        pthread_sigmask(SIG_UNBLOCK, &waiting_, nullptr);
        pthread_sigmask(SIG_BLOCK, &waiting_, nullptr);
    }
}

} // namespace trivar
