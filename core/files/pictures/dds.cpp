// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

// DDS (Microsoft, Programming Guide for DDS): four bytes, a header of 124 and, in some files,
// another of 20.
namespace trivar {
namespace {

// A Packing gives the bytes per block of 4 x 4 pixels, by the name of the compression or by its
// number in the second header.
struct Packing {
    std::string_view name;
    std::uint32_t block_bytes;
};
constexpr std::array packings{Packing{"DXT1", 8},  Packing{"DXT3", 16}, Packing{"DXT5", 16},
                              Packing{"RXGB", 16}, Packing{"ATI1", 8},  Packing{"BC4U", 8},
                              Packing{"ATI2", 16}, Packing{"BC5U", 16}};
constexpr std::array<std::uint32_t, 4> numbers_of_16{83, 95, 96, 98}; // BC5, both of BC6H, BC7
constexpr std::uint32_t number_of_8 = 80;                             // BC4

std::uint32_t block_bytes(const ByteView& file)
{
    const std::string_view name = file.part(84, 4);
    const auto* const found = std::ranges::find(packings, name, &Packing::name);
    if (found != packings.end()) return found->block_bytes;
    if (name == "DX10") {
        const std::uint32_t number = file.little(128, 4);
        if (number == number_of_8) return 8;
        if (std::ranges::find(numbers_of_16, number) != numbers_of_16.end()) return 16;
    }
    throw Rejected("has an unknown compression; use DXT1, DXT3, DXT5, BC4, BC5, BC6H or BC7");
}

// Throws Rejected if a channel has an empty mask, because a decoder shifts by it up to its first
// bit.
void check_masks(const ByteView& file, std::uint32_t flags)
{
    constexpr std::uint32_t with_alpha = 1, alpha_only = 2, colors = 0x40, gray = 0x20000;
    const std::uint32_t bits = file.little(88, 4);
    if ((flags & (colors | gray | alpha_only)) == 0 || bits % 8 != 0 || bits < 8 || bits > 32)
        throw Rejected(
            fmt::format("is damaged: colours of type {} and {} bits do not exist", flags, bits));
    const bool all = (flags & colors) != 0;
    const std::array<bool, 4> wanted{all || (flags & gray) != 0, all, all,
                                     (flags & (with_alpha | alpha_only)) != 0};
    for (std::uint64_t channel = 0; channel < 4; ++channel) {
        const std::uint64_t mask = file.little(92 + 4 * channel, 4);
        if (wanted[channel] && (mask == 0 || mask >> bits != 0))
            throw Rejected("is damaged: one of its colours has no bits");
    }
}

} // namespace

PictureHead dds_head(const ByteView& file, Look look)
{
    const std::uint32_t wide = file.little(16, 4), high = file.little(12, 4);
    const PictureHead head{{file.side(wide), file.side(high)}, 4, 1};
    if (look == Look::head_only) return head;
    constexpr std::uint32_t cube = 0xfe00, deep = 0x200000, packed = 4;
    if (file.little(4, 4) != 124 || file.little(76, 4) != 32)
        throw Rejected("is damaged: its header has a wrong length");
    if ((file.little(112, 4) & (cube | deep)) != 0)
        throw Rejected("is a cube or a volume; use a flat picture");
    constexpr std::uint64_t begin = 128, second_head = 20;
    const std::uint32_t flags = file.little(80, 4);
    if ((flags & packed) != 0) {
        const std::uint64_t block = block_bytes(file),
                            more = file.part(84, 4) == "DX10" ? second_head : 0;
        file.part(begin + more, block * ((wide + 3) / 4) * ((high + 3) / 4));
    } else {
        check_masks(file, flags);
        file.part(begin, std::uint64_t{wide} * high * (file.little(88, 4) / 8));
    }
    return head;
}

} // namespace trivar
