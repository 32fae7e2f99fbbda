// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_sentences.h"
#include "core/voxels/inflate.h"
#include "core/voxels/meta_header.h"
#include "core/voxels/volume_readers.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// The samples in one file, `needed` bytes of them, behind the head that it may have.
std::string meta_samples(const MetaHeader& header, std::string_view bytes, std::uint64_t needed,
                         const std::string& name, const VolumeSource& source)
{
    const auto skip = static_cast<std::uint64_t>(std::max<std::int64_t>(header.header_bytes, 0));
    if (header.header_bytes < 0 && !header.packed && bytes.size() >= needed)
        return std::string(bytes.substr(static_cast<std::size_t>(bytes.size() - needed)));
    if (skip > bytes.size())
        source.refuse(fmt::format("{} has {} bytes; its HeaderSize is {}", name,
                                  with_commas(bytes.size()), with_commas(skip)));
    bytes.remove_prefix(static_cast<std::size_t>(skip));
    if (!header.packed) return std::string(bytes);
    check_ratio(bytes, Packing::zlib, needed, name);
    return unpacked(bytes, is_gzip(bytes) ? Packing::gzip : Packing::zlib, needed, name);
}

TakenSamples taken_of(const MetaHeader& header, std::string_view bytes, const std::string& name)
{
    if (!header.binary) return taken_words(bytes, header.block, name);
    check_bytes(header.block, bytes.size(), name);
    return taken_samples(bytes, header.block.type, header.order);
}

TakenSamples all_meta_samples(VolumeSource& source, const MetaHeader& header)
{
    const std::uint64_t needed = header.block.bytes(), count = header.data_files.size();
    if (count == 0) {
        const std::string_view behind = source.bytes().substr(header.size);
        if (!header.packed && header.header_bytes == 0)
            return taken_of(header, behind, source.name());
        return taken_of(header, meta_samples(header, behind, needed, source.name(), source),
                        source.name());
    }
    if (count == 1) {
        const std::string name = shown(header.data_files[0]);
        const std::string bytes = source.read_beside(header.data_files[0]);
        if (!header.packed && header.header_bytes == 0) return taken_of(header, bytes, name);
        return taken_of(header, meta_samples(header, bytes, needed, name, source), name);
    }
    if (!header.binary) source.refuse("numbers in words are in many files; one can be read");
    if (needed % count != 0)
        source.refuse(fmt::format("{} files cannot share {} bytes of samples equally", count,
                                  with_commas(needed)));
    std::string all;
    for (const std::string& file : header.data_files) {
        const std::string bytes = source.read_beside(file);
        const std::string part = meta_samples(header, bytes, needed / count, shown(file), source);
        if (part.size() != needed / count)
            source.refuse(fmt::format("{} has {} bytes of samples; each of the {} files needs {}",
                                      shown(file), with_commas(part.size()), count,
                                      with_commas(needed / count)));
        all += part;
    }
    return taken_of(header, all, source.name());
}

} // namespace

VoxelGrid read_meta_image(VolumeSource& source, const ReadVolumeOptions& options)
{
    const MetaHeader header = read_meta_header(source.bytes(), source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    VoxelGrid grid = grid_of(source, header.block, all_meta_samples(source, header), header.frame,
                             metres_per_unit(options, 0));
    grid.slope = header.slope;
    grid.intercept = header.intercept;
    return grid;
}

} // namespace trivar
