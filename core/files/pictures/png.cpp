// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"
#include "core/files/pictures/png_chunks.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

// PNG (W3C specification, 11.2.2): the first chunk is IHDR.
namespace trivar {
namespace {

// Number of channels by colour type; 0: not a valid type.
constexpr std::array<int, 7> png_channels{1, 0, 3, 3, 2, 0, 4};

} // namespace

PictureHead png_head(const ByteView& file, Look look)
{
    if (look == Look::whole)
        if (const std::string trouble = png_trouble(file.bytes); !trouble.empty())
            throw Rejected(trouble);
    if (file.part(12, 4) != "IHDR") throw Rejected("is damaged: it does not begin with its size");
    const std::uint32_t bits = file.byte(24), color = file.byte(25);
    const int channels = color < png_channels.size() ? png_channels[color] : 0;
    constexpr std::array<std::uint32_t, 5> depths{1, 2, 4, 8, 16};
    if (channels == 0 || std::ranges::find(depths, bits) == depths.end() ||
        (bits < 8 && channels > 1 && color != 3) || (bits > 8 && color == 3))
        throw Rejected(
            fmt::format("is damaged: colours of type {} and {} bits do not exist", color, bits));
    if (file.little(26, 2) != 0 || file.byte(28) > 1)
        throw Rejected("is damaged: its compression does not exist");
    return {{file.side(file.big(16, 4)), file.side(file.big(20, 4))}, channels, bits > 8 ? 2 : 1};
}

} // namespace trivar
