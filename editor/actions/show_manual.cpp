// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/show_manual.h"

#include "editor/editor.h"

namespace trivar {

void show_manual(Editor& editor, const std::string& page, std::size_t block)
{
    Editor::ManualDialog& dialog = editor.manual_dialog;
    if (editor.manual.empty()) editor.manual = manual_in(editor.manual_folder);
    if (editor.manual.empty()) editor.manual = {{keys_page, "Keys and mouse", {}}};
    dialog.open = true;
    dialog.page = page_of(editor.manual, page) ? page : editor.manual.back().name;
    dialog.show_block = block;
}

} // namespace trivar
