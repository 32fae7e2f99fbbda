// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/run_lines.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "editor/commands/typed_command.h"

#include <algorithm>
#include <vector>

namespace trivar {

bool is_no_step(std::string_view line)
{
    return line.empty() || line.starts_with("{\"trivar\"") || line.starts_with("{\"digest\"") ||
           line.starts_with("{\"effects\"");
}

std::string run_typed(Session& session, std::string_view text)
{
    try {
        const LogLine line = typed_line(text, session.committed());
        const History& history = session.scene().history();
        if (const auto* command = std::get_if<Command>(&line.what))
            return session.try_run(prepare(*command, *session.assets()), line.note);
        if (std::holds_alternative<UndoLine>(line.what)) {
            if (history.position() == 0) return "There is nothing to undo.";
            session.undo();
        } else {
            if (history.position() == history.steps().size()) return "There is nothing to redo.";
            session.redo();
        }
    } catch (const Rejected& why) {
        return why.what();
    }
    return {};
}

bool holds_lines(std::string_view text)
{
    const auto lines = trimmed_lines(text);
    return std::ranges::count_if(lines, [](auto line) { return !line.empty(); }) > 1;
}

void run_lines(Session& session, std::string_view text)
{
    const auto lines = trimmed_lines(text);
    std::size_t ran = 0;
    const auto counted = [](std::size_t count) {
        return std::to_string(count) + (count == 1 ? " line" : " lines");
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_no_step(lines[i])) continue;
        const std::string why = run_typed(session, lines[i]);
        if (!why.empty()) {
            session.notices.say(ui::NoticeKind::warning,
                                "Line " + std::to_string(i + 1) + " was refused",
                                why + (ran == 0 ? "" : " The " + counted(ran) + " before stand."));
            return;
        }
        ++ran;
    }
    session.notices.say(ui::NoticeKind::good,
                        counted(ran) + (ran == 1 ? " was" : " were") + " run");
}

} // namespace trivar
