// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace trivar {

struct Editor;

// Opens the manual at a block of a page; the last page, where there is none of that name.
void show_manual(Editor& editor, const std::string& page, std::size_t block = 0);

} // namespace trivar
