// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace trivar {

// While it lives Ctrl C (SIGINT) and SIGTERM wait to be asked for instead of ending the program, so
// that what is at hand can be finished. For threads that begin meanwhile, too.
class Interrupts {
public:
    Interrupts();
    ~Interrupts(); // what came is forgotten
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;
    bool came() const;

private:
    sigset_t waiting_{}, before_{};
};

} // namespace trivar
