// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_sentences.h"
#include "core/voxels/inflate.h"
#include "core/voxels/meta_header.h"
#include "core/voxels/volume_readers.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// The samples in one file from a place on, `needed` bytes of them, behind the head that it may
// have. `wrong` gets the number that there is of them where it is another one; it throws.
ByteStream meta_stream(const MetaHeader& header, const ByteFile& file, std::uint64_t from,
                       std::uint64_t needed, const std::string& name, const VolumeSource& source,
                       const std::function<void(std::uint64_t)>& wrong)
{
    const std::uint64_t bytes = file.size() - from;
    const auto skip = static_cast<std::uint64_t>(std::max<std::int64_t>(header.header_bytes, 0));
    if (header.header_bytes < 0 && !header.packed && bytes >= needed)
        return stream_of(file, file.size() - needed);
    if (skip > bytes)
        source.refuse(fmt::format("{} has {} bytes; its HeaderSize is {}", name, with_commas(bytes),
                                  with_commas(skip)));
    from += skip;
    if (!header.packed) {
        if (bytes - skip != needed) wrong(bytes - skip);
        return stream_of(file, from, needed);
    }
    std::string buffer;
    const Packing packing = is_gzip(file.part(from, 2, buffer)) ? Packing::gzip : Packing::zlib;
    check_ratio(bytes - skip, Packing::zlib, needed, name);
    return exactly(unpacked(file, from, bytes - skip, packing, name), needed,
                   [=](std::uint64_t present) {
                       if (present > needed) refuse_more(needed, name);
                       wrong(present);
                   });
}

// The samples of a file with numbers in words, which is read as a whole.
TakenSamples words_in(const MetaHeader& header, const ByteFile& file, std::uint64_t from,
                      const std::string& name, const VolumeSource& source)
{
    const ByteFile all = source.whole(file, name);
    from += static_cast<std::uint64_t>(std::max<std::int64_t>(header.header_bytes, 0));
    std::string unused, plain;
    std::string_view text = all.part(from, all.size(), unused);
    if (header.packed) {
        plain = unpacked(text, is_gzip(text) ? Packing::gzip : Packing::zlib, header.block.bytes(),
                         name);
        text = plain;
    }
    return taken_words(text, header.block, name);
}

// Takes the samples of one file from a place on.
void take_one(PartTaker& taker, const MetaHeader& header, const ByteFile& file, std::uint64_t from,
              const std::string& name, const VolumeSource& source, const ByteTurns& turns)
{
    if (!header.binary) {
        if (taker.wants_samples()) taker.take(words_in(header, file, from, name, source));
        return;
    }
    const ByteStream all =
        meta_stream(header, file, from, bytes_of(turns), name, source, [&](std::uint64_t present) {
            refuse_bytes(header.block, turns, present, name);
        });
    if (taker.wants_samples()) taker.take(chosen_volume(source, all, turns), header.order);
}

void take_samples(PartTaker& taker, const MetaHeader& header, VolumeSource& source)
{
    const ByteTurns turns = turns_of(source, header.block, header.volumes,
                                     header.block.bytes() / size_of(header.block.type));
    const std::uint64_t needed = bytes_of(turns), count = header.data_files.size();
    if (!header.binary && turns.things > 1)
        source.refuse("it holds several volumes as numbers in words; write it binary");
    if (count == 0)
        return take_one(taker, header, source.file(), header.size, source.name(), source, turns);
    if (count == 1)
        return take_one(taker, header, source.open_beside(header.data_files[0]), 0,
                        shown(header.data_files[0]), source, turns);
    if (!header.binary) source.refuse("numbers in words are in many files; one can be read");
    if (needed % count != 0)
        source.refuse(fmt::format("{} files cannot share {} bytes of samples equally", count,
                                  with_commas(needed)));
    const auto stream = [&](std::size_t number) {
        const std::string name = shown(header.data_files[number]);
        return meta_stream(header, source.open_beside(header.data_files[number]), 0, needed / count,
                           name, source, [&source, name, needed, count](std::uint64_t present) {
                               source.refuse(fmt::format(
                                   "{} has {} bytes of samples; each of the {} files needs {}",
                                   name, with_commas(present), count, with_commas(needed / count)));
                           });
    };
    if (taker.wants_samples())
        taker.take(chosen_volume(source, joined(count, stream), turns), header.order);
}

} // namespace

ReadVolume read_meta_image(VolumeSource& source, const ReadVolumeOptions& options)
{
    const MetaHeader header = read_meta_header(source.head(), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    PartTaker taker(header.block, options, source.name(), source.progress());
    take_samples(taker, header, source);
    ReadVolume out =
        volume_of(source, taker, header.block.type, header.frame, metres_per_unit(options, 0));
    out.grid.slope = header.slope;
    out.grid.intercept = header.intercept;
    return out;
}

} // namespace trivar
