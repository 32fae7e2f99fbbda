// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace trivar {
namespace {

template <class T> std::string shortest_of(T value)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

} // namespace

std::string shortest(float value)
{
    return shortest_of(value);
}

std::string shortest(double value)
{
    return shortest_of(value);
}

std::optional<double> parse_number(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string printable(std::string_view text)
{
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Utf8Letter next = first_letter(text);
        const bool control = next.number < 0x20 || (next.number >= 0x7F && next.number < 0xA0);
        if (next.bytes == 0 || control)
            shown += '?';
        else
            shown += text.substr(0, next.bytes);
        text.remove_prefix(std::max<std::size_t>(next.bytes, 1));
    }
    return shown;
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t most = 60;
    if (text.size() <= most) return printable(text);
    std::size_t end = most; // moved back to a character boundary below
    while (end > most - 4 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80) --end;
    return printable(text.substr(0, end)) + "...";
}

std::string short_sentence(std::string_view text)
{
    constexpr std::size_t most = 380;
    if (text.size() <= most) return printable(text);
    std::size_t begin = text.size() - most; // moved forward to a character boundary below
    while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xC0u) == 0x80)
        ++begin;
    return "..." + printable(text.substr(begin));
}

std::vector<std::string_view> trimmed_lines(std::string_view text)
{
    constexpr std::string_view blank = " \t\r";
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
        line.remove_suffix(line.size() - std::min(line.find_last_not_of(blank) + 1, line.size()));
        lines.push_back(line);
    }
    return lines;
}

std::string read_text_file(const std::string& path)
{
    constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30; // largest size of a .glb
    return read_file(path, most_bytes);
}

} // namespace trivar
