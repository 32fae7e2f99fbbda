// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/text_scan.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A number with the thing that it counts: "1 face", "3 faces".
std::string counted(std::size_t count, const char* one, const char* several);

// Words of a file, cut to a length that fits a sentence.
std::string shown(std::string_view words);

// A NameList is the first of many names, and their number: "a.png", "a.png and b.png", "a.png,
// b.png, c.png and 17 more".
class NameList {
public:
    void add(std::string_view name);
    std::size_t count() const { return count_; }
    std::string text() const;

private:
    std::vector<std::string> first_;
    std::size_t count_ = 0;
};

// Describes the fault of the next word of the line, which should be a number: "is missing", or "is
// 'abc', which is no number from -3.4e38 to 3.4e38".
std::string not_a_number(TextScan scan);

// The sentence for faces that name missing vertices, `count` of them, the first at `first`: that
// they were left out, or, where no other face is left, why there is no mesh.
std::string faces_left_out(std::size_t count, const std::string& first, std::size_t vertices);
std::string no_whole_face(const std::string& first, std::size_t vertices);

// The sentence for a file that has points and neither faces nor lines.
std::string points_alone(const std::string& file);

} // namespace trivar
