// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <sys/types.h>

namespace trivar::testing {

// A key by its name on X ("b", "Return", "Delete"), with what is held beside it.
struct Stroke {
    std::string key;
    bool ctrl = false, shift = false, alt = false;
};

// An X server of its own that no screen shows, and a hand at the keyboard of its windows.
class Screen {
public:
    static std::unique_ptr<Screen> open(); // null where Xvfb is not installed
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    const std::string& name() const; // as the variable DISPLAY has it
    bool shows(pid_t program);       // a window of it
    // Presses and lets go the key in the program's window. No effect where it has none.
    void strike(pid_t program, const Stroke& stroke);

private:
    Screen();
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar::testing
