// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>

// Radiance HDR (G. Ward): lines of text up to an empty one, a line with the size, pixels.
namespace trivar {
namespace {

constexpr std::uint64_t longest_text = 1 << 16;

struct HdrLine {
    std::string_view text;
    std::uint64_t next = 0;
};
HdrLine line_at(const ByteView& file, std::uint64_t at)
{
    const std::size_t end = file.part(at, file.size() - at).find('\n');
    if (end == std::string_view::npos || at + end > longest_text)
        throw Rejected("is damaged: its header has no end");
    return {file.part(at, end), at + end + 1};
}

// Parses the size: -Y 480 +X 640 is 480 rows of 640, from the top left; other signs are other
// corners.
glm::ivec2 size_of(std::string_view line)
{
    const auto refuse = [] {
        return Rejected("is damaged: its header has no size such as -Y 4 +X 8");
    };
    const auto number = [&](char axis) {
        if (line.size() < 4 || (line[0] != '-' && line[0] != '+') || line[1] != axis ||
            line[2] != ' ')
            throw refuse();
        line.remove_prefix(3);
        const std::string_view digits = line.substr(0, line.find(' '));
        if (digits.empty() || digits.size() > 9 ||
            digits.find_first_not_of("0123456789") != std::string_view::npos)
            throw refuse();
        line.remove_prefix(std::min(digits.size() + 1, line.size()));
        return static_cast<int>(parse_number(digits).value());
    };
    const int high = number('Y');
    return {number('X'), high};
}

} // namespace

PictureHead hdr_head(const ByteView& file, Look look)
{
    HdrLine line = line_at(file, 0);
    while (!line.text.empty()) line = line_at(file, line.next);
    line = line_at(file, line.next);
    const PictureHead head{size_of(line.text), 3, 4};
    if (look == Look::head_only) return head;
    // In the compressed form a row has 4 bytes and four channels, in which two bytes can stand for
    // 127 values.
    const auto wide = static_cast<std::uint64_t>(head.size_px.x);
    const auto high = static_cast<std::uint64_t>(head.size_px.y);
    const bool packed = wide >= 8 && wide < 32768 && file.big(line.next, 2) == 0x0202;
    file.part(line.next, high * (packed ? 4 + 4 * 2 * ((wide + 126) / 127) : 4));
    return head;
}

} // namespace trivar
