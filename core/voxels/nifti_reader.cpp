// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/voxels/inflate.h"
#include "core/voxels/nifti_header.h"
#include "core/voxels/volume_readers.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

// Takes the samples of the file that has them, packed by gzip or not.
void take_nifti(PartTaker& taker, const ByteFile& file, const NiftiHeader& header,
                const std::string& name, const VolumeSource& source, const ByteTurns& turns)
{
    const std::uint64_t needed = bytes_of(turns), before = header.data_offset;
    const auto refuse_short = [name, before](std::uint64_t bytes) {
        throw Rejected(fmt::format("{} has {} bytes; its samples should begin at byte {}", name,
                                   with_commas(bytes), with_commas(before)));
    };
    std::string buffer;
    if (!is_gzip(file.part(0, 2, buffer))) {
        if (before > file.size()) refuse_short(file.size());
        if (file.size() - before != needed)
            refuse_bytes(header.block, turns, file.size() - before, name);
        if (taker.wants_samples())
            taker.take(chosen_volume(source, stream_of(file, before), turns), header.order);
        return;
    }
    constexpr std::uint64_t most_before = std::uint64_t{1} << 30; // extensions of the head
    if (before > most_before)
        throw Rejected(
            fmt::format("{}: its samples begin at byte {}, which is too far", name, before));
    check_ratio(file.size(), Packing::gzip, before + needed, name);
    if (!taker.wants_samples()) return;
    const ByteStream stream = unpacked(file, 0, file.size(), Packing::gzip, name);
    if (const std::uint64_t skipped = stream.skip(before); skipped < before) refuse_short(skipped);
    const ByteStream all =
        exactly(stream, needed, [&header, &turns, name, needed, before](std::uint64_t present) {
            if (present > needed) refuse_more(before + needed, name);
            refuse_bytes(header.block, turns, present, name);
        });
    taker.take(chosen_volume(source, all, turns), header.order);
}

// The name of the file with the samples, of that with the head.
std::string samples_beside(const std::string& name)
{
    std::filesystem::path path(name);
    if (path.extension() == ".gz") path.replace_extension();
    return path.replace_extension(".img").string();
}

} // namespace

ReadVolume read_nifti(VolumeSource& source, const ReadVolumeOptions& options)
{
    const bool packed = is_gzip(source.head());
    const std::string head = packed ? first_unpacked(source.head(), nifti2_head_bytes)
                                    : std::string(source.head().substr(0, nifti2_head_bytes));
    if (!is_nifti(head)) source.refuse("is packed by gzip, but holds no NIfTI file");
    const NiftiHeader header = read_nifti_header(head, source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    const ByteTurns turns = turns_of(source, header.block, header.volumes,
                                     header.block.bytes() / size_of(header.block.type));
    const std::string beside = samples_beside(source.name());
    PartTaker taker(header.block, options, source.name(), source.progress());
    if (header.detached)
        take_nifti(taker, source.open_beside(beside), header, beside, source, turns);
    else
        take_nifti(taker, source.file(), header, source.name(), source, turns);
    ReadVolume out = volume_of(source, taker, header.block.type, header.frame,
                               metres_per_unit(options, header.metres_per_unit));
    out.grid.slope = header.slope;
    out.grid.intercept = header.intercept;
    return out;
}

} // namespace trivar
