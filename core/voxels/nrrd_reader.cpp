// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_sentences.h"
#include "core/voxels/nrrd_header.h"
#include "core/voxels/volume_readers.h"

#include <fmt/format.h>

namespace trivar {
namespace {

Packing packing_of(NrrdEncoding encoding)
{
    if (encoding == NrrdEncoding::gzip) return Packing::gzip;
    if (encoding == NrrdEncoding::bzip2) return Packing::bzip2;
    return Packing::none;
}

// The bytes that two digits each stand for. Blanks and ends of lines between them do not count.
std::string from_hex(std::string_view text, const VolumeSource& source)
{
    std::string out;
    int digits = 0, value = 0;
    for (const char c : text) {
        if (is_blank(c) || c == '\n') continue;
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (digit < 0)
            source.refuse(fmt::format("'{}' stands among its hexadecimal digits",
                                      shown(std::string_view(&c, 1))));
        value = 16 * value + digit;
        if (++digits % 2 == 0) {
            out += static_cast<char>(value);
            value = 0;
        }
    }
    if (digits % 2 != 0) source.refuse("its hexadecimal digits are an odd number");
    return out;
}

// One stream of an NRRD: what follows the head, or one of its files.
class NrrdStream {
public:
    NrrdStream(const NrrdHeader& header, const VolumeSource& source, std::string name)
        : header_(header),
          source_(source),
          name_(std::move(name))
    {
    }

    // The bytes of the samples, `needed` of them, or of words.
    std::string_view data(std::string_view bytes, std::uint64_t needed)
    {
        for (std::size_t line = 0; line < header_.line_skip; ++line) {
            const std::size_t end = bytes.find('\n');
            if (end == bytes.npos)
                source_.refuse(fmt::format("{} lines should be skipped in {}; it has {}",
                                           header_.line_skip, name_, line));
            bytes.remove_prefix(end + 1);
        }
        if (header_.encoding == NrrdEncoding::ascii) return after_skip(bytes);
        if (header_.encoding == NrrdEncoding::hex) {
            unpacked_ = from_hex(bytes, source_);
            bytes = unpacked_;
        } else if (const Packing packing = packing_of(header_.encoding); packing != Packing::none) {
            check_ratio(bytes, packing, needed, name_);
            unpacked_ = unpacked(bytes, packing, needed + skipped(), name_);
            bytes = unpacked_;
        }
        return header_.byte_skip < 0 ? last_of(bytes, needed) : after_skip(bytes);
    }

private:
    // Bytes beside the samples that a packed stream may have, at most.
    std::uint64_t skipped() const
    {
        constexpr std::uint64_t most_before = std::uint64_t{1} << 20;
        return header_.byte_skip < 0 ? most_before : static_cast<std::uint64_t>(header_.byte_skip);
    }

    std::string_view after_skip(std::string_view bytes) const
    {
        const auto skip = static_cast<std::uint64_t>(header_.byte_skip);
        if (header_.byte_skip < 0 || skip > bytes.size())
            source_.refuse(fmt::format("{} bytes should be skipped in {}; it has {}",
                                       header_.byte_skip, name_, with_commas(bytes.size())));
        return bytes.substr(static_cast<std::size_t>(skip));
    }

    // With a skip of -1 the samples are the last bytes of the stream; with -n, n - 1 bytes follow
    // them.
    std::string_view last_of(std::string_view bytes, std::uint64_t needed) const
    {
        const auto behind = static_cast<std::uint64_t>(-(header_.byte_skip + 1));
        if (behind > bytes.size() || needed > bytes.size() - behind)
            source_.refuse(fmt::format("{} has {} bytes; {} samples' bytes and {} behind them are "
                                       "needed",
                                       name_, with_commas(bytes.size()), with_commas(needed),
                                       with_commas(behind)));
        return bytes.substr(static_cast<std::size_t>(bytes.size() - behind - needed),
                            static_cast<std::size_t>(needed));
    }

    const NrrdHeader& header_;
    const VolumeSource& source_;
    std::string name_, unpacked_;
};

TakenSamples samples_of(VolumeSource& source, const NrrdHeader& header)
{
    const std::uint64_t needed = header.block.bytes();
    if (header.data_files.size() <= 1) {
        const bool attached = header.data_files.empty();
        const std::string name = attached ? source.name() : shown(header.data_files[0]);
        const std::string other =
            attached ? std::string() : source.read_beside(header.data_files[0]);
        NrrdStream stream(header, source, name);
        const std::string_view data =
            stream.data(attached ? source.bytes().substr(header.size) : other, needed);
        if (header.encoding == NrrdEncoding::ascii) return taken_words(data, header.block, name);
        check_bytes(header.block, data.size(), name);
        return taken_samples(data, header.block.type, header.order);
    }
    // Files behind one another, each with an equal part of the samples.
    const std::uint64_t count = header.data_files.size();
    if (header.encoding == NrrdEncoding::ascii)
        source.refuse("ASCII data are in many files; one can "
                      "be read");
    if (needed % count != 0 || needed / count % size_of(header.block.type) != 0)
        source.refuse(fmt::format("{} files cannot share {} bytes of samples equally", count,
                                  with_commas(needed)));
    std::string all;
    for (const std::string& name : header.data_files) {
        NrrdStream stream(header, source, shown(name));
        const std::string bytes = source.read_beside(name);
        const std::string_view data = stream.data(bytes, needed / count);
        if (data.size() != needed / count)
            source.refuse(fmt::format("{} has {} bytes of samples; each of the {} files needs {}",
                                      shown(name), with_commas(data.size()), count,
                                      with_commas(needed / count)));
        all += data;
    }
    return taken_samples(all, header.block.type, header.order);
}

} // namespace

VoxelGrid read_nrrd(VolumeSource& source, const ReadVolumeOptions& options)
{
    const NrrdHeader header = read_nrrd_header(source.bytes(), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    return grid_of(source, header.block, samples_of(source, header), header.frame,
                   metres_per_unit(options, header.metres_per_unit));
}

} // namespace trivar
