// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace trivar {

inline bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Walks over text word by word. Numbers are read without locale and to the nearest double.
struct TextScan {
    const char* at;
    const char* end;

    explicit TextScan(std::string_view text) : at(text.data()), end(at + text.size()) {}

    bool done() const { return at == end; }
    void skip_blanks()
    {
        while (at != end && is_blank(*at)) ++at;
    }
    // The rest of the line, without its end; the scan goes to the next line.
    std::string_view line()
    {
        const char* begin = at;
        while (at != end && *at != '\n') ++at;
        const std::string_view result(begin, static_cast<std::size_t>(at - begin));
        if (at != end) ++at;
        return result;
    }
    // The next word of this line; empty at its end.
    std::string_view word()
    {
        skip_blanks();
        const char* begin = at;
        while (at != end && !is_blank(*at) && *at != '\n') ++at;
        return {begin, static_cast<std::size_t>(at - begin)};
    }
    // Returns the rest of this line without the blanks around it; the scan stays where that begins.
    std::string_view rest()
    {
        skip_blanks();
        const char* stop = at;
        while (stop != end && *stop != '\n') ++stop;
        while (stop != at && is_blank(stop[-1])) --stop;
        return {at, static_cast<std::size_t>(stop - at)};
    }
    // A whole number of at most nine digits, or nothing; stops behind the last digit.
    std::optional<std::int32_t> integer()
    {
        const char* p = at;
        const bool negative = p != end && *p == '-';
        if (p != end && (*p == '-' || *p == '+')) ++p;
        const char* digits = p;
        std::int32_t value = 0;
        while (p != end && *p >= '0' && *p <= '9' && p - digits < 9)
            value = value * 10 + (*p++ - '0');
        if (p == digits || (p != end && *p >= '0' && *p <= '9')) return std::nullopt;
        at = p;
        return negative ? -value : value;
    }
    // A finite number that fits a float, or nothing; stops behind its last character.
    std::optional<double> number();
};

inline std::optional<double> TextScan::number()
{
    skip_blanks();
    const char* p = at;
    const bool negative = p != end && *p == '-';
    if (p != end && (*p == '-' || *p == '+')) ++p;
    // No second sign, and none of the words that from_chars takes for infinities.
    if (p == end || ((*p < '0' || *p > '9') && *p != '.')) return std::nullopt;
    const char* begin = p;
    std::uint64_t mantissa = 0;
    int digits = 0, exponent = 0;
    for (; p != end && *p >= '0' && *p <= '9'; ++p, ++digits)
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    if (p != end && *p == '.')
        for (++p; p != end && *p >= '0' && *p <= '9'; ++p, ++digits, --exponent)
            mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    // Up to 15 digits and 22 powers of ten both factors are exact doubles, so one operation rounds
    // right; the rare rest goes the general way.
    static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const bool plain = p == end || (*p != 'e' && *p != 'E');
    double value = 0;
    if (plain && digits > 0 && digits <= 15) {
        value = static_cast<double>(mantissa) / powers[-exponent];
    } else {
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc::result_out_of_range && stop != begin) {
            // Either too large or so small that it is zero.
            const auto text = std::string_view(begin, static_cast<std::size_t>(stop - begin));
            if (text.find("e-") == text.npos && text.find("E-") == text.npos) return std::nullopt;
            value = 0;
        } else if (error != std::errc{}) {
            return std::nullopt;
        }
        p = stop;
    }
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) return std::nullopt;
    at = p;
    return negative ? -value : value;
}

} // namespace trivar
