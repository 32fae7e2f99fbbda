// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/help/manual.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

struct Editor;

struct ManualPages {
    std::string folder; // they are read when the first is shown
    std::vector<ManualPage> pages;
};
struct ManualDialog {
    bool open = false;
    std::string page, search;
    std::vector<std::string> before;       // the pages whose links were followed
    std::optional<std::size_t> show_block; // scroll to it
};

// Opens the manual at a block of a page; the last page, where there is none of that name.
void show_manual(Editor& editor, const std::string& page, std::size_t block = 0);

} // namespace trivar
