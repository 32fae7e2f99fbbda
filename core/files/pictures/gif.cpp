// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

// GIF (CompuServe, GIF89a Specification, sections 17 to 26).
namespace trivar {
namespace {

// Skips blocks of at most 255 bytes, each with its length, up to an empty one.
std::uint64_t behind_blocks(const ByteView& file, std::uint64_t at)
{
    while (const std::uint32_t length = file.byte(at)) at += 1 + length;
    return at + 1;
}

std::uint64_t table_bytes(std::uint32_t flags)
{
    return flags & 0x80 ? 3u << ((flags & 7) + 1) : 0;
}

} // namespace

PictureHead gif_head(const ByteView& file, Look look)
{
    const PictureHead head{{file.little(6, 2), file.little(8, 2)}, 4, 1};
    if (look == Look::head_only) return head;
    for (std::uint64_t at = 13 + table_bytes(file.byte(10));;) {
        constexpr std::uint32_t extension = 0x21, picture = 0x2c;
        const std::uint32_t kind = file.byte(at);
        if (kind == extension) {
            at = behind_blocks(file, at + 2);
            continue;
        }
        if (kind != picture) throw Rejected("is damaged: it has no pixels");
        if (file.little(at + 1, 2) + file.little(at + 5, 2) > file.little(6, 2) ||
            file.little(at + 3, 2) + file.little(at + 7, 2) > file.little(8, 2))
            throw Rejected("is damaged: its pixels reach beyond its edges");
        at += 10 + table_bytes(file.byte(at + 9));
        if (file.byte(at) < 1 || file.byte(at) > 8)
            throw Rejected("is damaged: its pixels have a wrong number of bits");
        behind_blocks(file, at + 1);
        return head;
    }
}

} // namespace trivar
