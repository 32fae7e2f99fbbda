// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The shortest decimal text that reads back as the same bits. No locale.
std::string shortest(float value);
std::string shortest(double value);

// The whole text as a finite number, or nothing. No locale.
std::optional<double> parse_number(std::string_view text);

// Words of a file for a message: what would not show as itself, or end it, is a question mark, and
// so is each byte that is no UTF-8.
std::string printable(std::string_view text);

// The same, cut after some 60 bytes, so that a sentence stays one.
std::string excerpt(std::string_view text);

// What is to be told as one sentence, whatever a file or a path brings into it: printable, and where
// it is longer than 380 bytes cut in front, since what is wrong stands at the end.
std::string short_sentence(std::string_view text);

// The text's lines without the blanks at their ends, in their order; empty ones too.
std::vector<std::string_view> trimmed_lines(std::string_view text);

// The whole content of a file. Throws Rejected, naming the file and the reason.
std::string read_text_file(const std::string& path);

} // namespace trivar
