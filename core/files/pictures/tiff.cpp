// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <vector>

// TIFF (Adobe, Revision 6.0): the first directory of the file has entries of 12 bytes: tag, type,
// count, values.
namespace trivar {
namespace {

enum : std::uint32_t {
    tag_width = 256,
    tag_height = 257,
    tag_bits = 258,
    tag_packing = 259,
    tag_strips = 273,
    tag_channels = 277,
    tag_rows_a_strip = 278,
    tag_strip_bytes = 279,
    tag_apart = 284,
    tag_tile_width = 322,
    tag_tile_height = 323,
    tag_tiles = 324,
    tag_tile_bytes = 325
};

class TiffDirectory {
public:
    explicit TiffDirectory(const ByteView& file) : file_(file), first_low_(file.part(0, 2) == "II")
    {
        at_ = number(4, 4);
        count_ = number(at_, 2);
        file.part(at_, 2 + 12 * std::uint64_t{count_} + 4);
    }

    // Returns the numbers of a tag; empty if it is missing. Types other than unsigned integers are
    // ignored.
    std::vector<std::uint32_t> all(std::uint32_t tag) const
    {
        for (std::uint64_t entry = at_ + 2; entry < at_ + 2 + 12 * std::uint64_t{count_};
             entry += 12) {
            if (number(entry, 2) != tag) continue;
            const std::uint32_t type = number(entry + 2, 2), count = number(entry + 4, 4);
            const int each = type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : 0;
            if (each == 0) return {};
            const std::uint64_t length = std::uint64_t{count} * static_cast<unsigned>(each);
            const std::uint64_t begin = length <= 4 ? entry + 8 : number(entry + 8, 4);
            file_.part(begin, length);
            std::vector<std::uint32_t> out;
            for (std::uint64_t at = begin; at < begin + length; at += static_cast<unsigned>(each))
                out.push_back(number(at, each));
            return out;
        }
        return {};
    }
    std::uint32_t one(std::uint32_t tag, std::uint32_t otherwise) const
    {
        const std::vector<std::uint32_t> numbers = all(tag);
        return numbers.empty() ? otherwise : numbers.front();
    }

private:
    std::uint32_t number(std::uint64_t at, int count) const
    {
        return first_low_ ? file_.little(at, count) : file_.big(at, count);
    }

    const ByteView& file_;
    bool first_low_;
    std::uint32_t at_ = 0, count_ = 0;
};

// TiffPieces are strips over the whole width, or tiles.
struct TiffPieces {
    std::uint64_t wide, high;
    std::vector<std::uint32_t> begin, bytes;
};
TiffPieces tiff_pieces(const TiffDirectory& directory, const glm::ivec2& size)
{
    if (const std::uint32_t wide = directory.one(tag_tile_width, 0); wide != 0)
        return {wide, directory.one(tag_tile_height, 0), directory.all(tag_tiles),
                directory.all(tag_tile_bytes)};
    const auto high = static_cast<std::uint32_t>(size.y);
    return {static_cast<std::uint64_t>(size.x),
            std::min(directory.one(tag_rows_a_strip, high), high), directory.all(tag_strips),
            directory.all(tag_strip_bytes)};
}

void check_pieces(const ByteView& file, const TiffDirectory& directory, const PictureHead& head)
{
    const TiffPieces pieces = tiff_pieces(directory, head.size_px);
    // Decoders hold a whole piece. Usual are strips of 8 kB, and tiles of 64 to 1024 pixels.
    constexpr std::uint64_t most = 1 << 14;
    if (pieces.wide == 0 || pieces.high == 0 || pieces.wide > most || pieces.high > most)
        throw Rejected("is damaged: its strips or tiles have a wrong size");
    const auto wide = static_cast<std::uint64_t>(head.size_px.x);
    const auto high = static_cast<std::uint64_t>(head.size_px.y);
    const std::uint64_t layers =
        directory.one(tag_apart, 1) == 2 ? static_cast<unsigned>(head.channels) : 1;
    const std::uint64_t count =
        (wide + pieces.wide - 1) / pieces.wide * ((high + pieces.high - 1) / pieces.high) * layers;
    if (pieces.begin.size() < count || pieces.bytes.size() < count)
        throw Rejected(fmt::format("is damaged: it names {} of its {} strips or tiles",
                                   std::min(pieces.begin.size(), pieces.bytes.size()), count));
    for (std::size_t i = 0; i < count; ++i) file.part(pieces.begin[i], pieces.bytes[i]);
}

} // namespace

PictureHead tiff_head(const ByteView& file, Look look)
{
    const TiffDirectory directory(file);
    const std::vector<std::uint32_t> bits = directory.all(tag_bits);
    const std::uint32_t deepest = bits.empty() ? 1 : *std::ranges::max_element(bits);
    if (deepest < 1 || deepest > 64)
        throw Rejected(fmt::format("is damaged: colours of {} bits do not exist", deepest));
    const PictureHead head{
        {file.side(directory.one(tag_width, 0)), file.side(directory.one(tag_height, 0))},
        static_cast<int>(std::min(directory.one(tag_channels, 1), 1000u)),
        static_cast<int>(deepest + 7) / 8};
    if (look == Look::head_only) return head;
    // Uncompressed, three of fax machines, LZW, JPEG, both Deflates, PackBits.
    constexpr std::array<std::uint32_t, 9> packings{1, 2, 3, 4, 5, 7, 8, 32773, 32946};
    const std::uint32_t packing = directory.one(tag_packing, 1);
    if (std::ranges::find(packings, packing) == packings.end())
        throw Rejected(fmt::format("has the unknown compression {}; use LZW or Deflate", packing));
    check_pieces(file, directory, head);
    return head;
}

} // namespace trivar
