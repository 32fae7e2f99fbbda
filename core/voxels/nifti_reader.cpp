// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/voxels/inflate.h"
#include "core/voxels/nifti_header.h"
#include "core/voxels/volume_readers.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

// The samples in the file that has them, of which `bytes` are all, packed by gzip or not.
TakenSamples nifti_samples(std::string_view bytes, const NiftiHeader& header,
                           const std::string& name)
{
    const std::uint64_t needed = header.block.bytes();
    std::string plain;
    if (is_gzip(bytes)) {
        constexpr std::uint64_t most_before = std::uint64_t{1} << 30; // extensions of the head
        if (header.data_offset > most_before)
            throw Rejected(fmt::format("{}: its samples begin at byte {}, which is too far", name,
                                       header.data_offset));
        check_ratio(bytes, Packing::gzip, header.data_offset + needed, name);
        plain = unpacked(bytes, Packing::gzip, header.data_offset + needed, name);
        bytes = plain;
    }
    if (header.data_offset > bytes.size())
        throw Rejected(fmt::format("{} has {} bytes; its samples should begin at byte {}", name,
                                   with_commas(bytes.size()), with_commas(header.data_offset)));
    bytes.remove_prefix(static_cast<std::size_t>(header.data_offset));
    check_bytes(header.block, bytes.size(), name);
    return taken_samples(bytes, header.block.type, header.order);
}

// The name of the file with the samples, of that with the head.
std::string samples_beside(const std::string& name)
{
    std::filesystem::path path(name);
    if (path.extension() == ".gz") path.replace_extension();
    return path.replace_extension(".img").string();
}

} // namespace

VoxelGrid read_nifti(VolumeSource& source, const ReadVolumeOptions& options)
{
    const bool packed = is_gzip(source.bytes());
    const std::string head = packed ? first_unpacked(source.bytes(), nifti2_head_bytes)
                                    : std::string(source.bytes().substr(0, nifti2_head_bytes));
    if (!is_nifti(head)) source.refuse("is packed by gzip, but holds no NIfTI file");
    const NiftiHeader header = read_nifti_header(head, source.name());
    for (const std::string& sentence : header.notices) source.say(sentence);
    TakenSamples samples;
    if (header.detached) {
        const std::string beside = samples_beside(source.name());
        samples = nifti_samples(source.read_beside(beside), header, beside);
    } else {
        samples = nifti_samples(source.bytes(), header, source.name());
    }
    VoxelGrid grid = grid_of(source, header.block, std::move(samples), header.frame,
                             metres_per_unit(options, header.metres_per_unit));
    grid.slope = header.slope;
    grid.intercept = header.intercept;
    return grid;
}

} // namespace trivar
