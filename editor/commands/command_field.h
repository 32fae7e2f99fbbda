// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace trivar {

// A CommandField is the field for typed commands, at the foot of the log.
struct CommandField {
    std::string text, trouble;
    std::string offered;            // the text after which ...
    std::vector<std::string> words; // ... these could follow
    bool focus = false;             // takes the keyboard in the next frame
    bool active = false;            // has it
    std::vector<std::string> before;
    std::size_t recalled = 0; // steps back in `before`
};

} // namespace trivar
