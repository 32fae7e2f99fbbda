// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/image_stack.h"

#include "core/files/pictures/image.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

DeepImage grey_slice(std::uint16_t value)
{
    DeepImage image;
    image.size_px = {3, 2};
    for (std::uint16_t i = 0; i < 6; ++i)
        for (int channel = 0; channel < 4; ++channel)
            image.rgba.push_back(channel == 3 ? 65535 : static_cast<std::uint16_t>(value + i));
    return image;
}

Image small_slice(std::uint8_t red, std::uint8_t green)
{
    Image image;
    image.size_px = {3, 2};
    for (int i = 0; i < 6; ++i)
        for (const std::uint8_t channel : {red, green, red, std::uint8_t{255}})
            image.rgba.push_back(channel);
    return image;
}

TEST(ImageStack, GoesByNumbersAndNotByNames)
{
    const testing::TemporaryFolder folder;
    for (const int k : {2, 10, 9})
        testing::write_file(
            folder.file("slice" + std::to_string(k) + ".png"),
            encoded_image(grey_slice(static_cast<std::uint16_t>(1000 * k)), ".png"));
    testing::write_file(folder.file("notes.txt"), "not a slice");
    const ReadVolume read = read_volume(folder.path().string());
    EXPECT_EQ(read.grid.size, glm::ivec3(3, 2, 3));
    const auto& samples = std::get<std::vector<std::uint16_t>>(read.grid.samples);
    EXPECT_EQ(samples[0], 2000);
    EXPECT_EQ(samples[6], 9000);
    EXPECT_EQ(samples[17], 10005);
    EXPECT_EQ(read.companions.size(), 3u);
    ASSERT_EQ(read.grid.notices.size(), 2u);
    EXPECT_THAT(read.grid.notices[1], HasSubstr("after number 2 comes 9"));
}

TEST(ImageStack, KeepsEightBitsAsTheyAre)
{
    const testing::TemporaryFolder folder;
    for (int k = 0; k < 2; ++k) {
        const auto value = static_cast<std::uint8_t>(200 + k);
        testing::write_file(folder.file(std::to_string(k) + ".png"),
                            encoded_image(small_slice(value, value), ".png"));
    }
    const VoxelGrid grid = read_volume(folder.path().string()).grid;
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(grid.samples)[6], 201);
}

TEST(ImageStack, RefusesColoursAndOtherSizes)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("1.png"), encoded_image(small_slice(1, 1), ".png"));
    EXPECT_THROW(read_volume(folder.path().string()), Rejected);
    testing::write_file(folder.file("2.png"), encoded_image(small_slice(1, 30), ".png"));
    EXPECT_THROW(read_volume(folder.path().string()), Rejected);
    Image other = small_slice(1, 1);
    other.size_px = {2, 3};
    testing::write_file(folder.file("2.png"), encoded_image(other, ".png"));
    EXPECT_THROW(read_volume(folder.path().string()), Rejected);
}

} // namespace
} // namespace trivar
