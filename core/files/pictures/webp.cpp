// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>

// WebP (Google, WebP Container Specification; RFC 6386, 9.1 (VP8); WebP Lossless Bitstream, 3).
namespace trivar {
namespace {

PictureHead webp_frame(const ByteView& chunk, std::string_view name)
{
    if (name == "VP8 ") {
        if (chunk.part(3, 3) != "\x9d\x01\x2a")
            throw Rejected("is damaged: its frame has no header");
        return {{chunk.little(6, 2) & 0x3fff, chunk.little(8, 2) & 0x3fff}, 4, 1};
    }
    if (chunk.byte(0) != 0x2f) throw Rejected("is damaged: its frame has no header");
    const std::uint32_t bits = chunk.little(1, 4);
    return {{(bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1}, 4, 1};
}

} // namespace

PictureHead webp_head(const ByteView& file, Look look)
{
    constexpr std::uint64_t begin = 12, around = 8; // RIFF, length, WEBP; chunk name and length
    if (look == Look::whole) file.part(around, file.little(4, 4));
    const bool has_canvas = file.part(begin, 4) == "VP8X";
    const auto side = [&](std::uint64_t at) { return static_cast<int>(file.little(at, 3)) + 1; };
    const PictureHead canvas{has_canvas ? glm::ivec2(side(24), side(27)) : glm::ivec2(0), 4, 1};
    if (has_canvas && look == Look::head_only) return canvas;
    for (std::uint64_t at = begin;;) {
        const std::string_view name = file.part(at, 4);
        const std::uint64_t length = file.little(at + 4, 4);
        if (name == "ANMF") { // animated: its first frame is shown
            const glm::ivec2 end(2 * file.little(at + 8, 3) + side(at + 14),
                                 2 * file.little(at + 11, 3) + side(at + 17));
            if (end.x > canvas.size_px.x || end.y > canvas.size_px.y)
                throw Rejected("is damaged: its pixels reach beyond its edges");
            file.part(at + around, length);
            return canvas;
        }
        if (name == "VP8 " || name == "VP8L") {
            const std::uint64_t known = look == Look::whole ? length : 10; // enough for its header
            const PictureHead head = webp_frame({file.part(at + around, std::min(length, known)),
                                                 "is damaged: its frame ends early"},
                                                name);
            if (has_canvas && head.size_px != canvas.size_px)
                throw Rejected("is damaged: its frame and its header differ in size");
            return head;
        }
        at += around + length + length % 2;
    }
}

} // namespace trivar
