// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string_view>
#include <vector>

namespace trivar {

// The whole numbers of a text with a mark between each two, such as 1:240:2, 1/4 or 1280x720; none
// where there is anything else, a blank too, or a number that is no int. No locale.
inline std::vector<int> whole_numbers(std::string_view text, char mark)
{
    std::vector<int> numbers;
    const char *at = text.data(), *const end = at + text.size();
    while (true) {
        const auto read = std::from_chars(at, end, numbers.emplace_back());
        if (read.ec != std::errc{}) return {};
        if (read.ptr == end) return numbers;
        if (*read.ptr != mark) return {};
        at = read.ptr + 1;
    }
}

} // namespace trivar
