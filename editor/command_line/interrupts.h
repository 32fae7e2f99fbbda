// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace trivar {

// While it lives Ctrl C (SIGINT), SIGTERM and, where the terminal goes, SIGHUP wait to be asked for
// instead of ending the program, so that what is at hand can be finished; a second one ends it. For
// threads that begin meanwhile, too. What the program was started to ignore (nohup) it ignores.
class Interrupts {
public:
    Interrupts();
    ~Interrupts(); // what came is forgotten
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
