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

// An NrrdFile is one file of an NRRD, or the data after the head.
class NrrdFile {
public:
    NrrdFile(const NrrdHeader& header, const VolumeSource& source, ByteFile file,
             std::uint64_t from, std::string name)
        : header_(header),
          source_(source),
          file_(std::move(file)),
          from_(from),
          name_(std::move(name))
    {
        skip_lines();
    }

    // The samples, `needed` bytes of them. `wrong` gets the number that there is where it is
    // another one; it throws.
    ByteStream stream(std::uint64_t needed, const std::function<void(std::uint64_t)>& wrong)
    {
        const Packing packing = packing_of(header_.encoding);
        if (packing != Packing::none) {
            check_ratio(file_.size() - from_, packing, needed, name_);
            if (header_.byte_skip >= 0) return unpacked_stream(packing, needed, wrong);
        }
        // Data counted from the end of the file are unpacked as a whole.
        if (packing != Packing::none || header_.encoding == NrrdEncoding::hex) {
            const ByteFile all = source_.whole(file_, name_);
            std::string unused;
            const std::string_view bytes = all.part(from_, all.size(), unused);
            file_ = ByteFile::kept(header_.encoding == NrrdEncoding::hex
                                       ? from_hex(bytes, source_)
                                       : unpacked(bytes, packing, needed + most_before, name_));
            from_ = 0;
        }
        const std::uint64_t bytes = file_.size() - from_;
        if (header_.byte_skip < 0) return stream_of(file_, from_ + place_of_last(bytes, needed));
        const auto skip = static_cast<std::uint64_t>(header_.byte_skip);
        check_skip(bytes);
        if (bytes - skip != needed) wrong(bytes - skip);
        return stream_of(file_, from_ + skip);
    }

    // Its numbers in words; the file is read as a whole.
    TakenSamples words(const SampleBlock& block) const
    {
        const ByteFile all = source_.whole(file_, name_);
        check_skip(all.size() - from_);
        std::string unused;
        return taken_words(
            all.part(from_ + static_cast<std::uint64_t>(header_.byte_skip), all.size(), unused),
            block, name_);
    }

private:
    // Bytes beside the samples that a packed file may have whose samples are its last, at most.
    static constexpr std::uint64_t most_before = std::uint64_t{1} << 20;

    void skip_lines()
    {
        constexpr std::uint64_t at_once = std::uint64_t{1} << 16;
        std::string buffer;
        for (std::size_t line = 0; line < header_.line_skip;) {
            const std::string_view bytes = file_.part(from_, at_once, buffer);
            if (bytes.empty())
                source_.refuse(fmt::format("{} lines should be skipped in {}; it has {}",
                                           header_.line_skip, name_, line));
            std::size_t at = 0;
            while (line < header_.line_skip) {
                const std::size_t end = bytes.find('\n', at);
                at = end == bytes.npos ? bytes.size() : end + 1;
                if (end == bytes.npos) break;
                ++line;
            }
            from_ += at;
        }
    }

    ByteStream unpacked_stream(Packing packing, std::uint64_t needed,
                               const std::function<void(std::uint64_t)>& wrong)
    {
        const ByteStream all = unpacked(file_, from_, file_.size() - from_, packing, name_);
        const auto skip = static_cast<std::uint64_t>(header_.byte_skip);
        if (const std::uint64_t skipped = all.skip(skip); skipped < skip) check_skip(skipped);
        return exactly(all, needed, [=, name = name_](std::uint64_t present) {
            if (present > needed) refuse_more(skip + needed, name);
            wrong(present);
        });
    }

    void check_skip(std::uint64_t bytes) const
    {
        if (header_.byte_skip < 0 || static_cast<std::uint64_t>(header_.byte_skip) > bytes)
            source_.refuse(fmt::format("{} bytes should be skipped in {}; it has {}",
                                       header_.byte_skip, name_, with_commas(bytes)));
    }

    // With a skip of -1 the samples are the last bytes; with -n, n - 1 bytes follow them.
    std::uint64_t place_of_last(std::uint64_t bytes, std::uint64_t needed) const
    {
        const auto behind = static_cast<std::uint64_t>(-(header_.byte_skip + 1));
        if (behind > bytes || needed > bytes - behind)
            source_.refuse(fmt::format("{} has {} bytes; {} samples' bytes and {} behind them are "
                                       "needed",
                                       name_, with_commas(bytes), with_commas(needed),
                                       with_commas(behind)));
        return bytes - behind - needed;
    }

    const NrrdHeader& header_;
    const VolumeSource& source_;
    ByteFile file_;
    std::uint64_t from_;
    std::string name_;
};

// Keeps the samples of one volume of several.
TakenSamples one_volume(TakenSamples all, const ByteTurns& turns, const VolumeSource& source,
                        std::size_t sample_bytes)
{
    if (turns.things == 1) return all;
    std::visit(
        [&](auto& samples) {
            const std::size_t run = turns.run / sample_bytes, turn = run * turns.things;
            const std::size_t first = run * (static_cast<std::size_t>(source.time()) - 1);
            std::size_t count = 0;
            for (std::size_t at = first; at < samples.size(); at += turn)
                for (std::size_t k = 0; k < run; ++k) samples[count++] = samples[at + k];
            samples.resize(count);
        },
        all.samples);
    return all;
}

void take_samples(PartTaker& taker, VolumeSource& source, const NrrdHeader& header)
{
    const ByteTurns turns = turns_of(source, header.block, header.volumes, header.in_turn);
    const std::uint64_t needed = bytes_of(turns);
    if (header.data_files.size() <= 1) {
        const bool attached = header.data_files.empty();
        const std::string name = attached ? source.name() : shown(header.data_files[0]);
        NrrdFile file(header, source,
                      attached ? source.file() : source.open_beside(header.data_files[0]),
                      attached ? header.size : 0, name);
        if (header.encoding == NrrdEncoding::ascii) {
            SampleBlock all = header.block;
            all.size[2] *= static_cast<std::int64_t>(turns.things);
            if (taker.wants_samples())
                taker.take(one_volume(file.words(all), turns, source, size_of(all.type)));
            return;
        }
        if (!taker.wants_samples()) return;
        const ByteStream all = file.stream(needed, [&header, &turns, name](std::uint64_t present) {
            refuse_bytes(header.block, turns, present, name);
        });
        taker.take(chosen_volume(source, all, turns), header.order);
        return;
    }
    // Files behind one another, each with an equal part of the samples.
    const std::uint64_t count = header.data_files.size();
    if (header.encoding == NrrdEncoding::ascii)
        source.refuse("ASCII data are in many files; one can "
                      "be read");
    if (needed % count != 0 || needed / count % size_of(header.block.type) != 0)
        source.refuse(fmt::format("{} files cannot share {} bytes of samples equally", count,
                                  with_commas(needed)));
    const auto stream = [&](std::size_t number) {
        const std::string name = shown(header.data_files[number]);
        NrrdFile file(header, source, source.open_beside(header.data_files[number]), 0, name);
        return file.stream(needed / count, [&source, name, needed, count](std::uint64_t present) {
            source.refuse(fmt::format("{} has {} bytes of samples; each of the {} files needs {}",
                                      name, with_commas(present), count,
                                      with_commas(needed / count)));
        });
    };
    if (taker.wants_samples())
        taker.take(chosen_volume(source, joined(count, stream), turns), header.order);
}

} // namespace

ReadVolume read_nrrd(VolumeSource& source, const ReadVolumeOptions& options)
{
    const NrrdHeader header = read_nrrd_header(source.head(), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    PartTaker taker(header.block, options, source.name(), source.progress());
    take_samples(taker, source, header);
    return volume_of(source, taker, header.block.type, header.frame,
                     metres_per_unit(options, header.metres_per_unit));
}

} // namespace trivar
