// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace trivar {

struct Editor;
class Session;

// A LogEntry is a line of the file, or a command that was refused and is in no file.
struct LogEntry {
    std::size_t number = 0; // in the file; 0: refused
    std::string_view line, why;
};
// All entries in the order in which they came.
std::vector<LogEntry> log_entries(const Session& session);

struct LogLines { // those that are selected
    std::optional<std::size_t> from;
    std::size_t to = 0;
    bool dragging = false;
};
bool log_lines_chosen(const Editor& editor); // in the log, which is shown
bool copy_log_lines(Editor& editor);         // to the clipboard, as they stand; whether there were

} // namespace trivar
