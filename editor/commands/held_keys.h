// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

// Keys that mean something else while they are held.

namespace trivar {

struct LentTool { // by a key that is held
    int key = 0;
    std::size_t before = 0; // the tool that comes back
    bool used = false;      // by the mouse
};

struct HeldSpace {
    bool down = false;
    bool used = false; // for something else than what it does alone
};

} // namespace trivar
