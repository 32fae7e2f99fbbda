// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/log_lines.h"

#include "editor/commands/clipboard.h"
#include "editor/editor.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {

std::vector<LogEntry> log_entries(const Session& session)
{
    const std::vector<std::string>& lines = session.scene().lines();
    std::vector<LogEntry> entries;
    entries.reserve(lines.size() + session.refused().size());
    auto refused = session.refused().begin();
    const auto end = session.refused().end();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (; refused != end && refused->after <= i; ++refused)
            entries.push_back({0, refused->line, refused->why});
        entries.push_back({i + 1, lines[i], {}});
    }
    for (; refused != end; ++refused) entries.push_back({0, refused->line, refused->why});
    return entries;
}

bool log_lines_chosen(const Editor& editor)
{
    return editor.memory.of<LogLines>().from && editor.tab == Editor::Tab::log &&
           editor.preferences.show_dock && !editor.only_view;
}

bool copy_log_lines(Editor& editor)
{
    if (!log_lines_chosen(editor)) return false;
    const std::vector<LogEntry> entries = log_entries(editor.session);
    const auto& lines = editor.memory.of<LogLines>();
    const auto [first, last] = std::minmax(*lines.from, lines.to);
    std::string text;
    std::size_t count = 0;
    for (std::size_t i = first; i <= last && i < entries.size(); ++i, ++count)
        text += std::string(entries[i].line) + "\n";
    ImGui::SetClipboardText(text.c_str());
    editor.session.notices.say(ui::NoticeKind::good,
                               count == 1 ? "A line was copied"
                                          : std::to_string(count) + " lines were copied",
                               {}, of_clipboard);
    return true;
}

} // namespace trivar
