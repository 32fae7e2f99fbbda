// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"
#include "tests/voxels/volume_writers.h"

#include <cstring>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::refusal;

template <class T> void set(std::string& bytes, std::size_t at, T value)
{
    std::memcpy(bytes.data() + at, &value, sizeof(T));
}

std::string small_nifti()
{
    return write_nifti(testing::small_volume());
}

// The same with 64-bit sizes and matrix.
std::string second_nifti()
{
    const VoxelGrid grid = testing::small_volume();
    std::string out(544, '\0');
    set(out, 0, std::int32_t{540});
    std::memcpy(out.data() + 4, "n+2\0\r\n\032\n", 8);
    set(out, 12, std::int16_t{4});
    set(out, 14, std::int16_t{16});
    set(out, 16, std::int64_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
        set(out, 24 + 8 * k, static_cast<std::int64_t>(grid.size[static_cast<int>(k)]));
        for (std::size_t column = 0; column < 4; ++column)
            set(out, 400 + 32 * k + 8 * column,
                1000 * (k < 2 ? -1 : 1) *
                    grid.to_metres[static_cast<int>(column)][static_cast<int>(k)]);
    }
    set(out, 168, std::int64_t{544});
    set(out, 176, 2.0);
    set(out, 184, -1024.0);
    set(out, 348, std::int32_t{1});
    set(out, 500, std::int32_t{2});
    return out + testing::packed<std::int16_t>(grid);
}

// Reverses the bytes of the fields that the reader looks at.
std::string as_big_endian(std::string bytes)
{
    const auto turn = [&](std::size_t at, std::size_t size, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at + k * size),
                         bytes.begin() + static_cast<std::ptrdiff_t>(at + (k + 1) * size));
    };
    turn(0, 4, 1), turn(40, 2, 8), turn(70, 2, 2), turn(76, 4, 8), turn(108, 4, 3), turn(252, 2, 2);
    turn(256, 4, 18);
    turn(352, 2, (bytes.size() - 352) / 2);
    return bytes;
}

TEST(Nifti, GivesBackWhatWasWritten)
{
    VoxelGrid grid = testing::small_volume();
    grid.slope = 0.5;
    grid.intercept = -3;
    for (const std::string& bytes : {write_nifti(grid), testing::gzipped(write_nifti(grid))}) {
        const VoxelGrid read = read_volume_bytes(bytes, "a.nii", "").grid;
        EXPECT_EQ(read.samples, grid.samples);
        EXPECT_EQ(read.slope, 0.5);
        EXPECT_EQ(read.intercept, -3);
        testing::expect_same_place(read.to_metres, grid.to_metres, 1e-9);
        EXPECT_TRUE(read.notices.empty());
    }
}

TEST(Nifti, ReadsTheOtherOrderOfBytes)
{
    const VoxelGrid read = read_volume_bytes(as_big_endian(small_nifti()), "a.nii", "").grid;
    EXPECT_EQ(read.samples, testing::small_volume().samples);
    testing::expect_same_place(read.to_metres, testing::small_volume().to_metres, 1e-9);
}

TEST(Nifti, ReadsTheSecondVersion)
{
    const VoxelGrid read = read_volume_bytes(second_nifti(), "a.nii", "").grid;
    EXPECT_EQ(read.samples, testing::small_volume().samples);
    EXPECT_EQ(read.value(10), -1004);
    testing::expect_same_place(read.to_metres, testing::small_volume().to_metres, 1e-15);
}

TEST(Nifti, ReadsTheSamplesBesideTheHead)
{
    const testing::TemporaryFolder folder;
    const std::string all = small_nifti();
    std::string head = all.substr(0, 348);
    head[345] = 'i';
    set(head, 108, 0.0f);
    testing::write_file(folder.file("a.hdr"), head);
    testing::write_file(folder.file("a.img"), all.substr(352));
    for (const char* name : {"a.hdr", "a.img"}) {
        const ReadVolume read = read_volume(folder.file(name));
        EXPECT_EQ(read.grid.samples, testing::small_volume().samples);
        EXPECT_EQ(read.companions.size(), 1u);
    }
    testing::write_file(folder.file("a.img"), all.substr(353));
    EXPECT_THROW(read_volume(folder.file("a.hdr")), Rejected);
}

// A turn of 90 degrees about z: x of the grid goes along y of space. Quaternion (cos 45, 0, 0, sin
// 45).
TEST(Nifti, TurnsByTheQuaternionWhereThereIsNoMatrix)
{
    std::string bytes = small_nifti();
    set(bytes, 254, std::int16_t{0});
    set(bytes, 252, std::int16_t{1});
    set(bytes, 264, static_cast<float>(std::sqrt(0.5)));
    for (std::size_t k = 0; k < 3; ++k) {
        set(bytes, 80 + 4 * k, static_cast<float>(k + 1));
        set(bytes, 268 + 4 * k, static_cast<float>(10 * k));
    }
    set(bytes, 76, -1.0f); // z goes the other way
    const glm::dmat4 m = read_volume_bytes(bytes, "a.nii", "").grid.to_metres;
    const glm::dmat4 expected{
        {0, -0.001, 0, 0}, {0.002, 0, 0, 0}, {0, 0, -0.003, 0}, {0, -0.01, 0.02, 1}};
    testing::expect_same_place(m, expected, 1e-9);
}

TEST(Nifti, SaysWhereTheOrientationIsMissing)
{
    std::string bytes = small_nifti();
    set(bytes, 254, std::int16_t{0});
    const VoxelGrid read = read_volume_bytes(bytes, "a.nii", "").grid;
    testing::expect_same_place(read.to_metres, testing::upright_mm({0.7, 0.8, 1.25}, {0, 0, 0}),
                               1e-9);
    ASSERT_EQ(read.notices.size(), 1u);
    EXPECT_THAT(read.notices[0], HasSubstr("does not say how the patient lies"));
}

TEST(Nifti, KeepsItsUnit)
{
    std::string bytes = small_nifti();
    bytes[123] = 3; // micrometres
    const glm::dmat4 m = read_volume_bytes(bytes, "a.nii", "").grid.to_metres;
    EXPECT_NEAR(m[0].x, 0.7e-6, 1e-12);
    ReadVolumeOptions told;
    told.metres_per_unit = 1;
    EXPECT_NEAR(read_volume_bytes(bytes, "a.nii", "", told).grid.to_metres[0].x, 0.7, 1e-6);
}

TEST(Nifti, RefusesAStreamThatWasCutWhereverItWas)
{
    const std::string whole = testing::gzipped(small_nifti());
    for (std::size_t size = 1; size < whole.size(); ++size)
        EXPECT_NE(refusal(whole.substr(0, size), "a.nii.gz"), "") << size;
    EXPECT_THAT(refusal(small_nifti() + "x", "a.nii"), HasSubstr("has 121 bytes of samples"));
}

TEST(Nifti, RefusesWhatIsNoVolume)
{
    const auto with = [](auto change) {
        std::string bytes = small_nifti();
        change(bytes);
        return refusal(bytes, "a.nii");
    };
    EXPECT_THAT(with([](auto& b) { set(b, 40, std::int16_t{4}), set(b, 48, std::int16_t{7}); }),
                HasSubstr("its 7 volumes need 120 each"));
    EXPECT_THAT(with([](auto& b) {
                    set(b, 40, std::int16_t{5});
                    set(b, 48, std::int16_t{1}), set(b, 50, std::int16_t{3});
                }),
                HasSubstr("3 values at each point"));
    EXPECT_THAT(with([](auto& b) { set(b, 70, std::int16_t{128}); }), HasSubstr("colours"));
    EXPECT_THAT(with([](auto& b) { set(b, 70, std::int16_t{32}); }), HasSubstr("complex"));
    EXPECT_THAT(with([](auto& b) { set(b, 72, std::int16_t{8}); }), HasSubstr("8 bits for each"));
    EXPECT_THAT(with([](auto& b) { set(b, 42, std::int16_t{-5}); }), HasSubstr("-5 x 4 x 3"));
    EXPECT_THAT(with([](auto& b) { set(b, 46, std::int16_t{1}); }), HasSubstr("no volume"));
    EXPECT_THAT(with([](auto& b) { set(b, 108, 1e30f); }), HasSubstr("should begin"));
    EXPECT_THAT(with([](auto& b) {
                    for (std::size_t k = 0; k < 3; ++k) set(b, 42 + 2 * k, std::int16_t{32000});
                }),
                HasSubstr("need 65,536,000,000,000"));
}

} // namespace
} // namespace trivar
