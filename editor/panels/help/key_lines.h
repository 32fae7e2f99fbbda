// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

struct Editor;

// The tool at hand, the mouse, and every action that has a key, from the tables that the program
// works by, so that they cannot tell anything else.
struct KeyLine {
    std::string what, how; // no `how`: a heading
};
std::vector<KeyLine> key_lines(const Editor& editor);

} // namespace trivar
