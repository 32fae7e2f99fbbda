// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include "core/base/ordinary_file.h"

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
    std::string shown(text);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return shown;
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
    constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30; // as many as a .glb can have
    return read_file(path, most_bytes);
}

} // namespace trivar
