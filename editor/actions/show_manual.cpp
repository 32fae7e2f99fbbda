// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/show_manual.h"

#include "editor/editor.h"

namespace trivar {

void show_manual(Editor& editor, const std::string& page, std::size_t block)
{
    auto& dialog = editor.memory.of<ManualDialog>();
    auto& [folder, pages] = editor.memory.of<ManualPages>();
    if (pages.empty()) pages = manual_in(folder);
    if (pages.empty()) pages = {{keys_page, "Keys and mouse", {}}};
    dialog.open = true;
    dialog.page = page_of(pages, page) ? page : pages.back().name;
    dialog.show_block = block;
}

} // namespace trivar
