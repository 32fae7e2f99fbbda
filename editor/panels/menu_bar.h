// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar {

struct MenuBar {
    std::string open, next; // of its menus; and in the next frame
    bool by_letter = false; // it was opened by its letter
    bool beside = false;    // another one is open beside it
};

} // namespace trivar
