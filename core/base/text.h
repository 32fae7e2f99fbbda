// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The shortest decimal text that reads back as the same bits, in any locale.
std::string shortest(float value);
std::string shortest(double value);

// The whole text as a finite number, or empty. The locale does not matter.
std::optional<double> parse_number(std::string_view text);

// The words of a file for a message. Characters that cannot be shown or would end the message
// become question marks, and so does each byte that is not UTF-8.
std::string printable(std::string_view text);

// The same, cut after some 60 bytes, so that a sentence stays short.
std::string excerpt(std::string_view text);

// Makes a sentence of a text that a file or a path may have contributed to: printable, and cut in
// front if it is longer than 380 bytes, because its end tells the fault.
std::string short_sentence(std::string_view text);

// The lines of a text in their order, without the blanks at their ends; empty lines too.
std::vector<std::string_view> trimmed_lines(std::string_view text);

// The whole content of an ordinary file. Throws Rejected, naming the file and the reason.
std::string read_text_file(const std::string& path);

} // namespace trivar
