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

// Words of a file for a message: what would not show as itself, or end it, is a question mark.
std::string printable(std::string_view text);

// The text's lines without the blanks at their ends, in their order; empty ones too.
std::vector<std::string_view> trimmed_lines(std::string_view text);

// The whole content of an ordinary file. Throws Rejected, naming the file and the reason.
std::string read_text_file(const std::string& path);

} // namespace trivar
