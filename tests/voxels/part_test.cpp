// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/image.h"
#include "core/voxels/coarsened.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/dicom_files.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"
#include "tests/voxels/volume_writers.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <random>

namespace trivar {
namespace {

using ::testing::HasSubstr;

const std::vector<SampleBox>& boxes_of_5_4_3()
{
    static const std::vector<SampleBox> boxes{{{0, 0, 0}, {4, 3, 2}}, {{1, 0, 0}, {4, 3, 2}},
                                              {{0, 1, 0}, {3, 2, 2}}, {{0, 0, 1}, {4, 3, 2}},
                                              {{1, 1, 0}, {3, 3, 1}}, {{3, 2, 1}, {4, 3, 2}}};
    return boxes;
}

VoxelGrid part_of(const VoxelGrid& whole, const SampleBox& box, int coarsen)
{
    return coarsened(cropped(whole, box), glm::ivec3(coarsen));
}

void expect_alike(const VoxelGrid& read, const VoxelGrid& made)
{
    EXPECT_EQ(read.size, made.size);
    EXPECT_TRUE(read.samples == made.samples);
    EXPECT_TRUE(read.to_metres == made.to_metres);
    EXPECT_EQ(read.slope, made.slope);
    EXPECT_EQ(read.intercept, made.intercept);
    EXPECT_EQ(read.value_unit, made.value_unit);
}

// Expects parts of a volume, at once and slice by slice, to be those of the whole.
void expect_parts(const std::string& path, const std::vector<SampleBox>& boxes,
                  ReadVolumeOptions options = {})
{
    const ReadVolume whole = read_volume(path, options);
    for (const SampleBox& box : boxes)
        for (const int coarsen : {1, 2, 3}) {
            SCOPED_TRACE(::testing::Message() << path << ' ' << box.first.x << ' ' << box.first.y
                                              << ' ' << box.first.z << " by " << coarsen);
            options.box = box;
            options.coarsen = coarsen;
            const VoxelGrid made = part_of(whole.grid, box, coarsen);
            const ReadVolume part = read_volume(path, options);
            expect_alike(part.grid, made);
            EXPECT_EQ(part.companions, whole.companions);
            EXPECT_EQ(part.part.whole, whole.grid.size);
            EXPECT_EQ(part.part.size(), made.size);
            VoxelGrid joined = made;
            std::visit([](auto& all) { all.clear(); }, joined.samples);
            int slices = 0;
            ReadVolumeOptions by_slices = options;
            by_slices.each_slice = [&](int slice, const VoxelGrid::Samples& samples) {
                EXPECT_EQ(slice, slices++);
                std::visit(
                    [&](auto& all) {
                        const auto& more = std::get<std::remove_cvref_t<decltype(all)>>(samples);
                        all.insert(all.end(), more.begin(), more.end());
                    },
                    joined.samples);
            };
            EXPECT_EQ(read_volume(path, by_slices).grid.count(), made.count());
            EXPECT_TRUE(joined.samples == made.samples);
        }
}

TEST(GridPart, IsThatOfTheWholeInEveryFormat)
{
    const testing::TemporaryFolder folder;
    for (const testing::NamedBytes& each : testing::sound_volumes()) {
        testing::write_file(folder.file(each.name), each.bytes);
        expect_parts(folder.file(each.name), boxes_of_5_4_3());
    }
}

TEST(GridPart, IsThatOfTheWholeInSeriesAndStacks)
{
    const testing::TemporaryFolder series, pictures;
    for (const testing::NamedSlice& each : testing::oblique_series(9))
        testing::write_file(series.file(each.name), testing::dicom_file(each.slice));
    const std::vector<SampleBox> boxes{{{0, 0, 0}, {5, 4, 8}}, {{1, 2, 3}, {4, 4, 7}}};
    expect_parts(series.path().string(), boxes);
    for (int k = 0; k < 9; ++k) {
        DeepImage image;
        image.size_px = {6, 5};
        for (int i = 0; i < 30; ++i)
            for (int channel = 0; channel < 4; ++channel)
                image.rgba.push_back(
                    static_cast<std::uint16_t>(channel == 3 ? 65535 : 1000 * k + 31 * i));
        testing::write_file(pictures.file("slice" + std::to_string(k) + ".png"),
                            encoded_image(image, ".png"));
    }
    expect_parts(pictures.path().string(), boxes);
}

// Slices at uneven places, of which the grid has means, scaled differently.
TEST(GridPart, IsThatOfTheWholeInUnevenSeries)
{
    const testing::TemporaryFolder folder;
    std::vector<testing::NamedSlice> slices = testing::oblique_series(8);
    for (std::size_t k = 0; k < slices.size(); ++k)
        slices[k].slice.slope = 1 + 0.25 * static_cast<double>(k % 3);
    std::erase_if(slices,
                  [](const testing::NamedSlice& each) { return each.slice.samples[0] == 300; });
    for (const testing::NamedSlice& each : slices)
        testing::write_file(folder.file(each.name), testing::dicom_file(each.slice));
    expect_parts(folder.path().string(), {{{0, 0, 0}, {5, 4, 7}}, {{0, 1, 2}, {5, 3, 5}}});
}

// More than is read at once, in types that are kept otherwise.
TEST(GridPart, IsThatOfTheWholeOverManyReads)
{
    const testing::TemporaryFolder folder;
    std::mt19937 random(7);
    VoxelGrid grid;
    grid.size = {1201, 701, 11};
    std::vector<float> values(grid.count());
    for (float& value : values) value = static_cast<float>(random() % 100'000) / 7;
    grid.samples = values;
    testing::write_file(folder.file("a.nrrd"), write_nrrd(grid));
    testing::write_file(folder.file("a.nii.gz"), testing::gzipped(write_nifti(grid)));
    std::vector<double> doubles(values.begin(), values.end());
    for (double& value : doubles) value *= 1.0000001;
    testing::write_file(folder.file("a_1201x701x11_f64.raw"),
                        std::string(reinterpret_cast<const char*>(doubles.data()),
                                    doubles.size() * sizeof(double)));
    const std::vector<SampleBox> boxes{{{0, 0, 0}, {1200, 700, 10}}, {{5, 9, 1}, {1004, 690, 9}}};
    for (const char* name : {"a.nrrd", "a.nii.gz", "a_1201x701x11_f64.raw"})
        expect_parts(folder.file(name), boxes);
}

TEST(GridPart, OfManyFilesIsThatOfTheWhole)
{
    const testing::TemporaryFolder folder;
    const std::string data = testing::packed<std::int16_t>(testing::small_volume());
    const std::string head = "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nendian: little\n";
    // Their ends are not at ends of slices.
    for (int k = 0; k < 5; ++k)
        testing::write_file(folder.file("p" + std::to_string(k) + ".gz"),
                            testing::gzipped(data.substr(static_cast<std::size_t>(24 * k), 24)));
    testing::write_file(folder.file("a.nhdr"), head + "encoding: gzip\ndata file: p%d.gz 0 4 1\n");
    expect_parts(folder.file("a.nhdr"), boxes_of_5_4_3());
}

TEST(GridPart, StaysWithinTheVolume)
{
    const std::string bytes = write_nrrd(testing::small_volume());
    ReadVolumeOptions options;
    options.box = SampleBox{{0, 0, 0}, {5, 3, 2}};
    EXPECT_THAT(testing::refusal(bytes, "a.nrrd", options),
                HasSubstr("is no part of its 5 x 4 x 3"));
    options.box = SampleBox{{2, 0, 0}, {2, 3, 2}};
    EXPECT_THAT(testing::refusal(bytes, "a.nrrd", options), HasSubstr("is no part"));
}

TEST(GridPart, FitsIntoTheMemoryOrIsRefused)
{
    // The samples take 120 bytes.
    const std::string bytes = write_nrrd(testing::small_volume());
    const VoxelGrid grid = read_volume_bytes(bytes, "a.nrrd", "").grid;
    ReadVolumeOptions options;
    options.memory_bytes = 119;
    EXPECT_THAT(testing::refusal(bytes, "a.nrrd", options),
                HasSubstr("take 120 bytes of memory, more than the 119 allowed; one for 2 along "
                          "each axis would fit"));
    options.if_too_large = TooLarge::coarsen;
    const ReadVolume read = read_volume_bytes(bytes, "a.nrrd", "", options);
    EXPECT_EQ(read.part.coarsen, 2);
    expect_alike(read.grid, coarsened(grid, glm::ivec3(2)));
    options.if_too_large = TooLarge::head;
    EXPECT_EQ(read_volume_bytes(bytes, "a.nrrd", "", options).grid.bytes(), 0u);
    options.bytes_beside = 4;
    options.memory_bytes = 359;
    EXPECT_EQ(read_volume_bytes(bytes, "a.nrrd", "", options).grid.bytes(), 0u);
    options.memory_bytes = 360;
    EXPECT_EQ(read_volume_bytes(bytes, "a.nrrd", "", options).grid.bytes(), 120u);
    options.if_too_large = TooLarge::coarsen;
    options.memory_bytes = 3;
    EXPECT_THAT(testing::refusal(bytes, "a.nrrd", options), HasSubstr("allowed"));
}

TEST(GridPart, MayBeTheHeadAlone)
{
    ReadVolumeOptions options;
    options.head_only = true;
    options.memory_bytes = 1000;
    for (const testing::NamedBytes& each : testing::sound_volumes()) {
        const ReadVolume read = read_volume_bytes(each.bytes, each.name, "", options);
        EXPECT_EQ(read.grid.size, glm::ivec3(5, 4, 3)) << each.name;
        EXPECT_EQ(read.grid.bytes(), 0u) << each.name;
    }
}

// Bytes that the process holds or held at most since the last call, as Linux counts them.
std::size_t resident_bytes(const char* field)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field))
            return std::stoull(line.substr(std::string(field).size())) << 10;
    return 0;
}

// A file of 1 GB, nearly all of it a hole, is read at 1/4096 of it, and at full size in a box.
TEST(GridPart, TakesMemoryForThePartAndAFewSlices)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("a_1024x1024x512_u16.raw");
    constexpr std::uintmax_t bytes = std::uintmax_t{1} << 30;
    {
        std::ofstream file(path, std::ios::binary);
    }
    std::filesystem::resize_file(path, bytes);
    {
        std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
        file.seekp(static_cast<std::streamoff>(bytes - 2));
        file.write("\x39\x30", 2);
    }
    ReadVolumeOptions options;
    options.coarsen = 16;
    std::ofstream("/proc/self/clear_refs") << "5"; // from now on the greatest counts anew
    [[maybe_unused]] const std::size_t before = resident_bytes("VmRSS:");
    const ReadVolume coarse = read_volume(path, options);
    EXPECT_EQ(coarse.grid.size, glm::ivec3(64, 64, 32));
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(coarse.grid.samples).back(), 12345 / 4096);
    options.coarsen = 1;
    options.box = SampleBox{{900, 900, 450}, {1023, 1023, 511}};
    const ReadVolume box = read_volume(path, options);
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(box.grid.samples).back(), 12345);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // these keep what is freed
    // The slab has 16 slices of 2 MB, what is read at once 4 MB.
    EXPECT_LT(resident_bytes("VmHWM:"), before + (std::size_t{64} << 20));
#endif
}

} // namespace
} // namespace trivar
