// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

struct Editor;

// KeyLines list the current tool, the mouse, and every action that has a key, from the tables by
// which the program works, so that they are always true.
struct KeyLine {
    std::string what, how; // no `how`: a heading
};
std::vector<KeyLine> key_lines(const Editor& editor);

} // namespace trivar
