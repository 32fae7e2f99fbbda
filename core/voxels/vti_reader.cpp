// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/voxels/base64.h"
#include "core/voxels/inflate.h"
#include "core/voxels/volume_readers.h"
#include "core/voxels/vti_header.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Gives the bytes of an array one part after another, in order; parts of base64 each end with '='.
class VtiStream {
public:
    VtiStream(std::string_view text, bool base64, const VolumeSource& source)
        : left_(text),
          base64_(base64),
          source_(source)
    {
        while (base64_ && !left_.empty() && is_space(left_[0])) left_.remove_prefix(1);
    }

    std::string take(std::uint64_t count)
    {
        const std::uint64_t length = base64_ ? base64_length(static_cast<std::size_t>(
                                                   std::min<std::uint64_t>(count, left_.size())))
                                             : count;
        if (count > left_.size() || length > left_.size())
            source_.refuse(
                fmt::format("its data end too early: {} bytes more should follow, {} are "
                            "there",
                            with_commas(length), with_commas(left_.size())));
        const std::string_view part = left_.substr(0, static_cast<std::size_t>(length));
        left_.remove_prefix(static_cast<std::size_t>(length));
        if (!base64_) return std::string(part);
        auto bytes = from_base64(part);
        if (!bytes || bytes->size() != count) source_.refuse("its base64 data are damaged");
        return std::move(*bytes);
    }

    // The first bytes of a part of unknown length; nothing is taken.
    std::string first(std::size_t count) const
    {
        const std::size_t length = base64_ ? base64_length(count) : count;
        auto bytes = base64_ ? from_base64(left_.substr(0, length))
                             : std::optional(std::string(left_.substr(0, length)));
        if (!bytes || bytes->size() < count)
            source_.refuse("its data end before their number of bytes");
        bytes->resize(count);
        return std::move(*bytes);
    }

private:
    static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

    std::string_view left_;
    bool base64_;
    const VolumeSource& source_;
};

std::uint64_t count_at(std::string_view bytes, std::size_t at, const VtiHeader& header)
{
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < header.count_bytes; ++k) {
        const std::size_t from = header.order == ByteOrder::big ? k : header.count_bytes - 1 - k;
        count = count << 8 | static_cast<unsigned char>(bytes[at + from]);
    }
    return count;
}

// Blocks of bytes, each packed by zlib: their number, the size of a whole one, that of the last one
// where it is not whole, the packed sizes of all; then the blocks.
std::string unpacked_blocks(VtiStream& stream, const VtiHeader& header, const VolumeSource& source)
{
    const std::uint64_t needed = header.block.bytes();
    const std::size_t each = header.count_bytes;
    // In base64 the numbers are one part, so they are looked at before it is known how many.
    const std::string first = stream.first(3 * each);
    const std::uint64_t count = count_at(first, 0, header), whole = count_at(first, each, header),
                        last = count_at(first, 2 * each, header);
    constexpr std::uint64_t most_blocks = std::uint64_t{1} << 32;
    const bool fits = count > 0 && count <= most_blocks && last <= needed &&
                      (count == 1 || whole <= needed / (count - 1));
    if (!fits || (count - 1) * whole + (last > 0 ? last : whole) != needed)
        source.refuse(
            fmt::format("its {} packed blocks of {} bytes, the last of {}, are not the {} "
                        "bytes of its samples",
                        count, whole, last, with_commas(needed)));
    const std::string numbers = stream.take((3 + count) * each);
    std::uint64_t packed = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint64_t size = count_at(numbers, (3 + k) * each, header);
        if (size > source.bytes().size())
            source.refuse("the sizes of its packed blocks are damaged");
        packed += size;
    }
    const std::string all = stream.take(packed);
    check_ratio(all, Packing::zlib, needed, source.name());
    std::string out;
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const auto size = static_cast<std::size_t>(count_at(numbers, (3 + k) * each, header));
        const std::uint64_t most = k + 1 < count || last == 0 ? whole : last;
        const std::string block =
            unpacked(std::string_view(all).substr(at, size), Packing::zlib, most, source.name());
        if (block.size() != most)
            source.refuse(fmt::format("its packed block {} has {} bytes; it needs {}", k,
                                      with_commas(block.size()), with_commas(most)));
        out += block;
        at += size;
    }
    return out;
}

// In base64 the number of bytes and the bytes are one part.
std::string plain_bytes(VtiStream& stream, const VtiHeader& header, const VolumeSource& source)
{
    const std::size_t before = header.count_bytes;
    const std::uint64_t said = count_at(stream.first(before), 0, header);
    check_bytes(header.block, said, source.name());
    std::string bytes = stream.take(before + said);
    bytes.erase(0, before);
    return bytes;
}

} // namespace

VoxelGrid read_vti(VolumeSource& source, const ReadVolumeOptions& options)
{
    const VtiHeader header = read_vti_header(source.bytes(), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    TakenSamples samples;
    if (header.format == VtiHeader::Format::ascii) {
        samples = taken_words(header.text, header.block, source.name());
    } else {
        std::string_view text = header.text;
        if (header.format != VtiHeader::Format::base64) {
            text = source.bytes().substr(header.appended);
            if (header.offset > text.size())
                source.refuse(fmt::format("its samples should begin at byte {} of {} that are "
                                          "appended",
                                          header.offset, text.size()));
            text.remove_prefix(static_cast<std::size_t>(header.offset));
        }
        VtiStream stream(text, header.format != VtiHeader::Format::appended_raw, source);
        const std::string bytes = header.packed ? unpacked_blocks(stream, header, source)
                                                : plain_bytes(stream, header, source);
        check_bytes(header.block, bytes.size(), source.name());
        samples = taken_samples(bytes, header.block.type, header.order);
    }
    return grid_of(source, header.block, std::move(samples), header.frame,
                   metres_per_unit(options, 0));
}

} // namespace trivar
