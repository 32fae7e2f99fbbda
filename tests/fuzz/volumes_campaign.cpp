// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/volumes_campaign.h"

#include "core/level/voxel_field.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/segments.h"
#include "core/voxels/usual_level.h"
#include "tests/fuzz/byte_damage.h"
#include "tests/fuzz/promises.h"
#include "tests/voxels/dicom_files.h"
#include "tests/voxels/volume_files.h"
#include "tests/voxels/volume_writers.h"

#include <filesystem>

namespace trivar::testing {
namespace {

std::string head_of_times(const std::string& lines)
{
    return "NRRD0004\ntype: short\ndimension: 4\nsizes: 2 5 4 3\nkinds: list domain domain domain\n"
           "endian: little\nencoding: raw\n" +
           lines + "\n";
}

std::vector<FileSet> sound_nrrds()
{
    const std::string data = packed<std::int16_t>(small_volume());
    return {{{"times.nrrd",
              head_of_times("Segment0_Name:=bone\nSegment0_LabelValue:=1\n") + data + data}},
            {{"head.nhdr", "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nendian: little\n"
                           "encoding: raw\ndata file: data.raw\n"},
             {"data.raw", data}}};
}

std::vector<FileSet> sound_series()
{
    std::vector<FileSet> out;
    for (const DicomPacking packing :
         {DicomPacking::none, DicomPacking::big_endian, DicomPacking::implicit, DicomPacking::rle,
          DicomPacking::deflated, DicomPacking::jpeg_lossless, DicomPacking::jpeg_ls}) {
        FileSet files;
        for (NamedSlice& each : oblique_series(4)) {
            each.slice.packing = packing;
            files.push_back({each.name, dicom_file(each.slice)});
        }
        out.push_back(std::move(files));
    }
    std::vector<DicomSlice> frames;
    for (const NamedSlice& each : oblique_series(4)) frames.push_back(each.slice);
    for (const FramePlaces places : {FramePlaces::enhanced, FramePlaces::spacing})
        out.push_back({{"frames.dcm", dicom_frames_file(frames, places)}});
    return out;
}

std::vector<FileSet> sound_volumes_of(const std::string& kind)
{
    if (kind == "dicom") return sound_series();
    std::vector<FileSet> out = kind == "nrrd" ? sound_nrrds() : std::vector<FileSet>();
    const std::string ending = kind == "nifti" ? ".nii" : kind == "meta" ? ".mha" : "." + kind;
    for (const NamedBytes& each : sound_volumes())
        if (each.name.find(ending) != std::string::npos) out.push_back({{each.name, each.bytes}});
    return out;
}

// Uses a grid like the program: describes it, shows its usual level, reads a part.
void use_grid(const VoxelGrid& grid)
{
    if (grid.size.x < 2 || grid.size.y < 2 || grid.size.z < 2)
        throw Broken("it has less than 2 samples along an axis");
    const std::size_t count =
        std::visit([](const auto& samples) { return samples.size(); }, grid.samples);
    if (count != grid.count()) throw Broken("it has another number of samples than its size");
    if (grid.slope == 0 || !(glm::determinant(glm::dmat3(grid.to_metres)) != 0))
        throw Broken("its place or its scale is no place or scale");
    const VolumeSummary summary = summary_of(grid);
    if (summary.not_finite > 0) throw Broken("a sample is not finite");
    check_sentences(grid.notices);
    constexpr std::size_t cheap = 1'000'000;
    if (count > cheap) return;
    const VoxelField field(make_ref(VoxelGrid(grid)), {});
    for (const double level : usual_levels(summary, grid))
        field.surface(field.level(level), LevelSide::above, grid.to_metres);
}

void use_volume(const std::string& path)
{
    ReadVolumeOptions options;
    options.memory_bytes = std::uintmax_t{1} << 26;
    const VoxelGrid grid = read_volume(path, options).grid;
    use_grid(grid);
    segments_of(path);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (const std::string& each : {path, folder})
        allowed([&] { use_grid(read_volume(each, options, {}, each == path ? 2 : 1).grid); });
    options.coarsen = 2;
    allowed([&] { read_volume(path, options); });
}

Campaign campaign_of(const std::string& kind)
{
    const std::vector<FileSet> sound = sound_volumes_of(kind);
    const auto damaged = [sound](std::uint64_t seed, int number) {
        Dice dice(seed, number);
        FileSet out = dice.one_of(sound);
        std::vector<std::string> others;
        for (const FileSet& set : sound) others.push_back(set[0].bytes);
        std::string& bytes = out[dice.below(out.size())].bytes;
        bytes = with_bytes_damaged(bytes, others, dice);
        return out;
    };
    return {damaged, use_volume};
}

} // namespace

std::vector<CampaignEntry> volumes_campaigns()
{
    std::vector<CampaignEntry> out;
    for (const char* kind : {"nrrd", "nifti", "meta", "vtk", "vti", "dicom"})
        out.push_back({"bytes", kind, [kind] { return campaign_of(kind); }});
    return out;
}

} // namespace trivar::testing
