// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/voxels/base64.h"
#include "core/voxels/inflate.h"
#include "core/voxels/volume_readers.h"
#include "core/voxels/vti_header.h"

#include <fmt/format.h>
#include <vector>

namespace trivar {
namespace {

// Gives the bytes of an array one part after another, in order: of a file, or of a text in base64,
// whose parts each end with '='.
class VtiStream {
public:
    VtiStream(ByteFile file, std::uint64_t at, const VolumeSource& source)
        : file_(std::move(file)),
          at_(at),
          source_(source)
    {
    }
    VtiStream(std::string_view text, const VolumeSource& source)
        : file_(text),
          left_(text),
          base64_(true),
          source_(source)
    {
        while (!left_.empty() && is_space(left_[0])) left_.remove_prefix(1);
    }

    // The next so many bytes as a file of their own.
    struct Part {
        ByteFile file;
        std::uint64_t at, count;
    };
    Part take(std::uint64_t count)
    {
        const std::uint64_t there = base64_ ? left_.size() : file_.size() - at_;
        const std::uint64_t length =
            base64_ ? base64_length(static_cast<std::size_t>(std::min(count, there))) : count;
        if (count > there || length > there)
            source_.refuse(
                fmt::format("its data end too early: {} bytes more should follow, {} are "
                            "there",
                            with_commas(length), with_commas(there)));
        if (!base64_) {
            at_ += count;
            return {file_, at_ - count, count};
        }
        auto bytes = from_base64(left_.substr(0, static_cast<std::size_t>(length)));
        left_.remove_prefix(static_cast<std::size_t>(length));
        if (!bytes || bytes->size() != count) source_.refuse("its base64 data are damaged");
        return {ByteFile::kept(std::move(*bytes)), 0, count};
    }
    std::string bytes(std::uint64_t count)
    {
        const Part part = take(count);
        std::string buffer;
        return std::string(part.file.part(part.at, part.count, buffer));
    }

    // The first bytes of a part of unknown length; nothing is taken.
    std::string first(std::size_t count) const
    {
        std::string buffer;
        auto bytes = base64_ ? from_base64(left_.substr(0, base64_length(count)))
                             : std::optional(std::string(file_.part(at_, count, buffer)));
        if (!bytes || bytes->size() < count)
            source_.refuse("its data end before their number of bytes");
        bytes->resize(count);
        return std::move(*bytes);
    }

private:
    static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

    ByteFile file_;
    std::uint64_t at_ = 0;
    std::string_view left_;
    bool base64_ = false;
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
ByteStream unpacked_blocks(VtiStream& stream, const VtiHeader& header, const VolumeSource& source)
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
    const std::string numbers = stream.bytes((3 + count) * each);
    std::vector<std::uint64_t> begins{0}; // of the packed blocks
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint64_t size = count_at(numbers, (3 + k) * each, header);
        if (size > source.size()) source.refuse("the sizes of its packed blocks are damaged");
        begins.push_back(begins.back() + size);
    }
    const VtiStream::Part all = stream.take(begins.back());
    check_ratio(all.count, Packing::zlib, needed, source.name());
    return joined(static_cast<std::size_t>(count), [=, &source](std::size_t k) {
        const std::uint64_t most = k + 1 < count || last == 0 ? whole : last;
        return exactly(unpacked(all.file, all.at + begins[k], begins[k + 1] - begins[k],
                                Packing::zlib, source.name()),
                       most, [=, &source](std::uint64_t present) {
                           if (present > most) refuse_more(most, source.name());
                           source.refuse(
                               fmt::format("its packed block {} has {} bytes; it needs {}", k,
                                           with_commas(present), with_commas(most)));
                       });
    });
}

// In base64 the number of bytes and the bytes are one part.
ByteStream plain_bytes(VtiStream& stream, const VtiHeader& header, const VolumeSource& source)
{
    const std::size_t before = header.count_bytes;
    const std::uint64_t said = count_at(stream.first(before), 0, header);
    check_bytes(header.block, said, source.name());
    const VtiStream::Part all = stream.take(before + said);
    return stream_of(all.file, all.at + before, said);
}

// The bytes in which the XML stands: the first ones where its samples are appended, else all.
std::string_view xml_of(VolumeSource& source)
{
    const std::string_view head = source.head();
    const std::size_t at = head.find("<AppendedData");
    if (at != head.npos && head.find('_', std::min(head.find('>', at), head.size())) != head.npos)
        return head;
    return source.bytes();
}

void take_samples(PartTaker& taker, const VtiHeader& header, VolumeSource& source)
{
    if (header.format == VtiHeader::Format::ascii) {
        if (taker.wants_samples())
            taker.take(taken_words(header.text, header.block, source.name()));
        return;
    }
    std::uint64_t from = 0;
    if (header.format != VtiHeader::Format::base64) {
        const std::uint64_t appended = source.size() - header.appended;
        if (header.offset > appended)
            source.refuse(fmt::format("its samples should begin at byte {} of {} that are "
                                      "appended",
                                      header.offset, appended));
        from = header.appended + header.offset;
    }
    const auto stream = [&] {
        if (header.format == VtiHeader::Format::appended_raw)
            return VtiStream(source.file(), from, source);
        if (header.format == VtiHeader::Format::base64) return VtiStream(header.text, source);
        return VtiStream(source.bytes().substr(static_cast<std::size_t>(from)), source);
    };
    if (!taker.wants_samples()) return;
    VtiStream bytes = stream();
    taker.take(header.packed ? unpacked_blocks(bytes, header, source)
                             : plain_bytes(bytes, header, source),
               header.order);
}

} // namespace

ReadVolume read_vti(VolumeSource& source, const ReadVolumeOptions& options)
{
    const VtiHeader header = read_vti_header(xml_of(source), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    PartTaker taker(header.block, options, source.name(), source.progress());
    take_samples(taker, header, source);
    return volume_of(source, taker, header.block.type, header.frame, metres_per_unit(options, 0));
}

} // namespace trivar
