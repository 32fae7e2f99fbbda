// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/raw_layout.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

TEST(Raw, IsReadAsTold)
{
    ReadVolumeOptions options;
    options.raw = RawLayout{{{5, 4, 3}, SampleType::i16}, ByteOrder::big, 7};
    options.spacing = {0.7, 0.8, 1.25};
    const std::string bytes =
        "1234567" + testing::packed<std::int16_t>(testing::small_volume(), true);
    const VoxelGrid read = read_volume_bytes(bytes, "a.raw", "", options).grid;
    EXPECT_EQ(read.samples, testing::small_volume().samples);
    testing::expect_same_place(read.to_metres, testing::upright_mm({0.7, 0.8, 1.25}, {0, 0, 0}));
    EXPECT_THAT(testing::refusal(bytes + "x", "a.raw", options), HasSubstr("has 121 bytes"));
}

TEST(Raw, IsReadAsItsNameSays)
{
    const std::string bytes = testing::packed<std::int16_t>(testing::small_volume());
    const VoxelGrid read = read_volume_bytes(bytes, "head_5x4x3_int16.raw", "").grid;
    EXPECT_EQ(read.samples, testing::small_volume().samples);
    ASSERT_FALSE(read.notices.empty());
    EXPECT_THAT(read.notices[0], HasSubstr("5 x 4 x 3 signed 16-bit whole numbers"));
}

TEST(Raw, SaysWhatItCouldBe)
{
    EXPECT_EQ(
        testing::refusal(std::string(64 * 64 * 64, 'a'), "head.raw"),
        "head.raw: a file without a head does not say its size and type, and 262,144 bytes do "
        "not tell them; give them, or name it such as head_64x64x64_u16.raw; it could be 64 x "
        "64 x 64 unsigned 8-bit whole numbers or 128 x 128 x 16 unsigned 8-bit whole numbers "
        "or 32 x 32 x 256 unsigned 8-bit whole numbers");
}

TEST(Raw, SaysWhatBytesTheSizesNeed)
{
    ReadVolumeOptions options;
    options.raw = RawLayout{{{64, 64, 64}, SampleType::u8}};
    EXPECT_EQ(testing::refusal(std::string(12000, 'a'), "head.raw", options),
              "head.raw has 12,000 bytes of samples; 64 x 64 x 64 voxels of 8 bits need 262,144");
    for (const std::int64_t bad :
         {std::int64_t{0}, std::int64_t{-3}, std::int64_t{1}, std::int64_t{1} << 31}) {
        options.raw->block.size[1] = bad;
        EXPECT_NE(testing::refusal(std::string(12000, 'a'), "head.raw", options), "") << bad;
    }
    options.raw->block.size = {2147483647, 2147483647, 2147483647};
    EXPECT_THAT(testing::refusal(std::string(12000, 'a'), "head.raw", options),
                HasSubstr("any file"));
}

TEST(RawGuesses, GoByTheNameFirst)
{
    const auto first = [](const std::string& name, std::uint64_t bytes) {
        const auto guesses = raw_guesses(name, bytes);
        return guesses.empty() ? std::string() : words_of(guesses[0].layout);
    };
    EXPECT_EQ(first("skull_256x256x113_uint8.raw", 256 * 256 * 113),
              "256 x 256 x 113 unsigned 8-bit whole numbers");
    EXPECT_EQ(first("a_10_20_30.raw", 10 * 20 * 30 * 2),
              "10 x 20 x 30 unsigned 16-bit whole numbers");
    EXPECT_EQ(first("a_10x20x30_short.raw", 10 * 20 * 30 * 2),
              "10 x 20 x 30 signed 16-bit whole numbers");
    EXPECT_EQ(first("a_float.raw", 4 * 27000), "30 x 30 x 30 32-bit floating point numbers");
    EXPECT_EQ(first("a.raw", 2 * 27000), "30 x 30 x 30 unsigned 16-bit whole numbers");
    EXPECT_EQ(first("a.raw", 7), "");
}

} // namespace
} // namespace trivar
