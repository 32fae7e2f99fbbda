// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

// BMP (Microsoft, Bitmap Storage): a file header of 14 bytes, then one that begins with its own
// length.
namespace trivar {

PictureHead bmp_head(const ByteView& file, Look look)
{
    constexpr std::array<std::uint32_t, 5> lengths{12, 40, 52, 108, 124}, depths{1, 4, 8, 16, 24};
    const std::uint32_t length = file.little(14, 4), begin = file.little(10, 4);
    if (length != 56 && std::ranges::find(lengths, length) == lengths.end())
        throw Rejected("is damaged: its header has an impossible length");
    const bool small = length == 12;
    const std::int64_t wide = small ? file.little(18, 2) : file.little(18, 4);
    std::int64_t high = small ? file.little(20, 2) : file.little(22, 4);
    if (!small && high > 0x7fffffff) high = (std::int64_t{1} << 32) - high; // negative: top-down
    const std::uint32_t bits = small ? file.little(24, 2) : file.little(28, 2);
    const std::uint32_t packing = small ? 0 : file.little(30, 4);
    if (bits != 32 && std::ranges::find(depths, bits) == depths.end())
        throw Rejected(fmt::format("is damaged: colours of {} bits do not exist", bits));
    if (packing > 3) throw Rejected("has an unknown compression; save it without compression");
    const PictureHead head{glm::ivec2(std::min<std::int64_t>(wide, 0x7fffffff),
                                      std::min<std::int64_t>(high, 0x7fffffff)),
                           4, 1};
    if (look == Look::head_only) return head;
    file.part(0, 14 + length);
    const auto row = static_cast<std::uint64_t>(wide * bits + 31) / 32 * 4;
    const bool plain = packing == 0 || packing == 3;
    file.part(begin, plain ? row * static_cast<std::uint64_t>(high) : 1);
    return head;
}

} // namespace trivar
