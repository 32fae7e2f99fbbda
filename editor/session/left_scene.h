// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>
#include <string>

namespace trivar {

// The scene without a name that a program left which was killed.
struct LeftScene {
    std::string path;
    std::time_t when = 0; // it was written last
};

} // namespace trivar
