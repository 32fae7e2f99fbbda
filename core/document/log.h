// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/history.h"

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
inline constexpr int log_version = 1;

struct UndoLine {};
struct RedoLine {};
struct DigestLine {
    std::string digest, effects; // empty: not said
};
struct LogLine {
    int number = 0; // in the file, from 1
    std::variant<Command, UndoLine, RedoLine, DigestLine> what;
};
struct Log {
    std::string name; // for messages
    std::vector<LogLine> lines;
    std::size_t good_bytes = 0;  // up to and without a torn last line
    bool ends_with_break = true; // the last good line does
    std::string notice;          // that a torn last line was dropped; or empty
};

// Strict. Throws Rejected as NAME:LINE: what is wrong. A last line that is no whole JSON and has
// no line break was torn by a crash: it is dropped and said.
Log read_log(std::string_view text, const std::string& name);

// Applies the lines to an empty document. Throws Rejected with NAME:LINE.
History replay(const Log& log);
// One line on top of a history; a digest line that does not fit throws CheckFailed.
void apply(History& history, const LogLine& line, const std::string& name);

std::string log_header();                             // each with its line break
std::string log_text(const History& history);         // all steps; the undone ones are undone
std::string compact_log_text(const History& history); // only the steps in force
std::string digest_line(const std::string& digest, const std::string& effects);

} // namespace trivar
