// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/scene/history.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trivar {

// The text of a scene: JSON Lines, a header and then one line for each commit, undo and redo.
//
//   {"trivar":1,"units":"m","up":"z"}
//   {"do":"add_box","name":"Box",...}
//   {"undo":true}
//   {"redo":true}
//   {"digest":"<of the causes>","effects":"<of what they give>"}     either or both
//   {"digest":"...","effects":"...","frame":48}                      effects in that frame
//
// A command, undo or redo may carry "digest" too: of the causes after it. A command may carry a
// "note": words of the author, one paragraph, which stay with it.
inline constexpr int log_version = 1;
inline constexpr std::size_t longest_note = 1024; // bytes

struct UndoLine {};
struct RedoLine {};
struct CheckLine {};
struct LogLine {
    int number = 0; // in the file, from 1
    std::variant<Command, UndoLine, RedoLine, CheckLine> what;
    std::string digest, effects; // of the document after this line; empty: not given
    std::optional<int> frame;    // of the effects; nothing: the scene's first
    std::string note;            // of a command
};
struct Log {
    std::string name; // used in messages
    std::vector<LogLine> lines;
    std::size_t good_bytes = 0;  // up to a torn last line, which is not included
    bool ends_with_break = true; // whether the last good line ends with one
    std::string notice;          // says that a torn last line was dropped; or empty
};

// Reads strictly. Throws Rejected as NAME:LINE: what is wrong. A last line that is no whole JSON
// and has no line break was torn by a crash: it is dropped, and the notice says so. A newer format
// version is refused.
Log read_log(std::string_view text, const std::string& name);

// The text without so many lines at its end; its first line, the header, stays.
std::string without_last_lines(std::string text, std::size_t count);

std::vector<std::string> lines_of(std::string_view text); // without line breaks

// Reads one line that is not the header. Throws Rejected, without its place.
LogLine read_log_line(std::string_view line);

// Applies one line to a history, by after() alone: what was taken once is taken again. Digests are
// not checked. Throws Rejected with NAME:LINE.
void apply(History& history, const LogLine& line, const std::string& name);
// Applies all lines to an empty document.
History replay(const Log& log);

// Both texts end with a line break.
std::string log_header();
std::string command_line(const Command& command, const std::string& note = {});
std::string undo_line();
std::string redo_line();
std::string check_line(const std::string& digest, const std::string& effects,
                       std::optional<int> frame = {});

// The whole text. Either all steps, followed by the undo lines for the undone ones, or only those
// in force.
std::string log_text(const History& history);
std::string compact_log_text(const History& history);

} // namespace trivar
