// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Throws Rejected, with `name` in the sentence, where the bytes are text in UTF-16 or UTF-32.
void refuse_wide_text(std::string_view bytes, const std::string& name);

// The bytes behind the mark that some editors put before UTF-8.
std::string_view without_mark(std::string_view bytes);

// The text of a file as the readers of lines want it: without that mark, and with '\n' at every
// line's end, where old Macs and some programs of today have '\r' alone. It is copied only where
// that changes something. Throws Rejected as refuse_wide_text does.
class PlainText {
public:
    PlainText(std::string_view bytes, const std::string& name);
    PlainText(const PlainText&) = delete;
    PlainText& operator=(const PlainText&) = delete;

    std::string_view view() const { return view_; }

    // Joins lines as in a Wavefront OBJ, where a backslash at the end of a line continues it.
    // Blanks take the place of the backslash and of the line's end.
    void join_lines();

    // Returns the line number, from 1, of a place in view(), as a text editor counts.
    std::size_t line_of(const char* at) const;

private:
    void copy();

    std::string_view view_;
    std::string copy_;
    std::vector<std::size_t> joined_; // offsets of the line ends that join_lines took out
};

} // namespace trivar
