// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"

#include <charconv>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace trivar {

// The whole numbers of a text that are separated by a mark, such as 1:240:2, 1/4 or 1280x720. Empty
// where the text holds anything else, also a blank, or a number that does not fit an int. The
// locale does not matter.
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

// The whole number in a JSON value, of any library with the names of nlohmann's. Throws Rejected
// where it is no whole number or does not fit the type.
template <class Whole> Whole whole_number(const auto& json)
{
    const bool fits =
        json.is_number_unsigned()
            ? std::in_range<Whole>(json.template get<std::uint64_t>())
            : json.is_number_integer() && std::in_range<Whole>(json.template get<std::int64_t>());
    if (!fits) throw Rejected("it has a number that is not whole or is too large");
    return json.template get<Whole>();
}

} // namespace trivar
