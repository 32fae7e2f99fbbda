// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace trivar {

// While an Interrupts lives, Ctrl C (SIGINT), SIGTERM and, where the terminal ends, SIGHUP wait to
// be asked for and do not end the program, so that the current work can be finished; a second one
// ends it. This also holds for threads that begin meanwhile. Signals that the program was started
// to ignore (nohup) stay ignored.
class Interrupts {
public:
    Interrupts();
    ~Interrupts(); // signals that came are forgotten
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;
    bool came() const { return came_; }

private:
    void wait();

    sigset_t waiting_{}, before_{};
    std::atomic<bool> came_ = false, over_ = false;
    std::thread waits_;
};

} // namespace trivar
