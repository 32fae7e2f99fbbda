// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <fmt/format.h>

// JPEG (ITU-T T.81, annex B): segments that begin with a marker, ff and another byte.
namespace trivar {
namespace {

enum : std::uint32_t { start_of_scan = 0xda, end_of_image = 0xd9 };

// Limits of the pixels of all scans together. A scan covers all pixels but may have few bytes: a
// thousand scans keep a decoder busy for hours. Usual are ten scans of ten pixels per byte.
constexpr std::uint64_t scanned_a_byte = 8192, scanned_anyway = 100 << 20;

bool stands_alone(std::uint32_t marker) // has no length
{
    return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

// Says whether a marker begins a frame that common decoders support: baseline, extended,
// progressive, also with arithmetic coding.
bool begins_frame(std::uint32_t marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

PictureHead jpeg_frame(const ByteView& file, std::uint64_t at, std::uint32_t marker)
{
    if (marker != 0xc0 && marker != 0xc1 && marker != 0xc2 && marker != 0xc9 && marker != 0xca)
        throw Rejected("is a rare kind of JPEG; save it as a baseline or progressive one");
    if (file.byte(at + 2) != 8)
        throw Rejected(fmt::format("has {} bits per channel; use 8", file.byte(at + 2)));
    const std::uint32_t channels = file.byte(at + 7);
    if (channels == 0 || channels > 4 || file.big(at, 2) != 8 + 3 * channels)
        throw Rejected("is damaged: its frame has a wrong number of channels");
    for (std::uint32_t c = 0; c < channels; ++c) {
        const std::uint32_t across = file.byte(at + 9 + 3 * c) >> 4;
        const std::uint32_t down = file.byte(at + 9 + 3 * c) & 15;
        if (across < 1 || across > 4 || down < 1 || down > 4)
            throw Rejected("is damaged: its channels have wrong sizes");
    }
    // Decoders of other than baseline files hold all coefficients, of two bytes each, to the end.
    return {{file.big(at + 5, 2), file.big(at + 3, 2)},
            static_cast<int>(channels),
            marker == 0xc0 || marker == 0xc1 ? 1 : 2};
}

} // namespace

PictureHead jpeg_head(const ByteView& file, Look look)
{
    PictureHead head;
    std::uint64_t frames = 0, scans = 0;
    for (std::uint64_t at = 2;;) {
        // Skips to the next marker, between segments and in scans, as decoders do.
        const auto is_marker = [&] {
            return file.byte(at) == 0xff && file.byte(at + 1) != 0 && file.byte(at + 1) != 0xff;
        };
        // If only the end is missing, all pixels may be there; the decoder finds out.
        const auto may_end = [&] { return scans == 1 && at + 1 >= file.size(); };
        while (!may_end() && !is_marker()) ++at;
        if (may_end()) break;
        const std::uint32_t marker = file.byte(at + 1);
        at += 2;
        if (marker == end_of_image) break;
        if (stands_alone(marker)) continue;
        const std::uint32_t length = file.big(at, 2);
        if (length < 2) throw Rejected("is damaged: a segment is shorter than its own length");
        file.part(at, length);
        if (begins_frame(marker)) {
            if (++frames > 1) throw Rejected("is damaged: it has two frames");
            head = jpeg_frame(file, at, marker);
            if (look == Look::head_only) return head;
        }
        if (marker == start_of_scan) ++scans;
        at += length;
    }
    if (frames == 0 || scans == 0) throw Rejected("is damaged: it has no pixels");
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(head.size_px.x) * static_cast<unsigned>(head.size_px.y);
    if (scans * pixels > scanned_anyway + scanned_a_byte * file.size())
        throw Rejected(fmt::format("has {} scans, far more than the usual ten", scans));
    return head;
}

} // namespace trivar
