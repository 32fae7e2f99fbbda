// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/pictures/image.h"
#include "tests/fuzz/sound_pictures.h"
#include "tests/support/fixtures.h"

#include <cstring>
#include <gmock/gmock.h>
#include <limits>

namespace trivar {
namespace {

using namespace testing;

// An OpenEXR file of one channel of floats, a row in each chunk, not compressed.
std::string exr_of(int width, const std::vector<float>& values)
{
    std::string file;
    const auto number = [&](auto value) {
        file.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    const auto attribute = [&](const char* name, const char* type, const std::string& value) {
        file.append(name).push_back('\0');
        file.append(type).push_back('\0');
        number(static_cast<std::int32_t>(value.size()));
        file += value;
    };
    const auto bytes_of = [](auto... numbers) {
        std::string out;
        (out.append(reinterpret_cast<const char*>(&numbers), sizeof(numbers)), ...);
        return out;
    };
    const int height = static_cast<int>(values.size()) / width;
    number(std::int32_t{20000630});
    number(std::int32_t{2});
    attribute("channels", "chlist",
              std::string("Y\0", 2) + bytes_of(2, std::int32_t{0}, 1, 1) + std::string(1, '\0'));
    attribute("compression", "compression", std::string(1, '\0'));
    attribute("dataWindow", "box2i", bytes_of(0, 0, width - 1, height - 1));
    attribute("displayWindow", "box2i", bytes_of(0, 0, width - 1, height - 1));
    attribute("lineOrder", "lineOrder", std::string(1, '\0'));
    attribute("pixelAspectRatio", "float", bytes_of(1.0f));
    attribute("screenWindowCenter", "v2f", bytes_of(0.0f, 0.0f));
    attribute("screenWindowWidth", "float", bytes_of(1.0f));
    file.push_back('\0');
    const std::size_t row = 8 + sizeof(float) * static_cast<std::size_t>(width);
    const std::size_t first = file.size() + 8 * static_cast<std::size_t>(height);
    for (int y = 0; y < height; ++y)
        number(static_cast<std::uint64_t>(first + row * static_cast<std::size_t>(y)));
    for (int y = 0; y < height; ++y) {
        number(static_cast<std::int32_t>(y));
        number(static_cast<std::int32_t>(row - 8));
        for (int x = 0; x < width; ++x) number(values[static_cast<std::size_t>(y * width + x)]);
    }
    return file;
}

GreyImage read_grey(const TemporaryFolder& folder, const std::string& name,
                    const std::string& bytes)
{
    static PictureReader reader; // whose other process decodes all of them
    write_file(folder.path() / name, bytes);
    return reader.read_grey(folder.file(name));
}

TEST(GreyImages, KeepSixteenBitsOfAPng)
{
    const TemporaryFolder folder;
    DeepImage deep{{5, 1}, {}};
    for (const int grey : {0, 1, 257, 40000, 65535})
        for (const int channel : {grey, grey, grey, 65535})
            deep.rgba.push_back(static_cast<std::uint16_t>(channel));
    const GreyImage image = read_grey(folder, "a.png", encoded_image(deep, ".png"));
    EXPECT_EQ(image.size_px, glm::ivec2(5, 1));
    EXPECT_THAT(image.values,
                ::testing::ElementsAre(0.0f, 1 / 65535.0f, 257 / 65535.0f, 40000 / 65535.0f, 1.0f));
}

TEST(GreyImages, AreTheStoredNumbersOfEightBits)
{
    const TemporaryFolder folder;
    Image image;
    image.size_px = {2, 2};
    for (const int grey : {0, 51, 102, 255})
        for (const int channel : {grey, grey, grey, 255})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    const std::vector<float> wanted{0.0f, 0.2f, 0.4f, 1.0f};
    for (const char* ending : {".png", ".tif", ".bmp", ".tga"})
        EXPECT_THAT(
            read_grey(folder, std::string("a") + ending, encoded_image(image, ending)).values,
            ::testing::Pointwise(::testing::FloatEq(), wanted))
            << ending;
    const GreyImage jpeg = read_grey(folder, "a.jpg", encoded_image(image, ".jpg"));
    ASSERT_EQ(jpeg.values.size(), 4u);
}

TEST(GreyImages, TakeFloatsAsTheyAreAndCountWhatIsNoNumber)
{
    const TemporaryFolder folder;
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const GreyImage image =
        read_grey(folder, "a.exr", exr_of(3, {0.5f, -2.25f, 7.5f, nan, inf, -1e30f}));
    EXPECT_EQ(image.size_px, glm::ivec2(3, 2));
    EXPECT_THAT(image.values, ::testing::ElementsAre(0.5f, -2.25f, 7.5f, 0.0f, 0.0f, 0.0f));
    EXPECT_EQ(image.no_numbers, 3u);
}

TEST(GreyImages, AreReadOfEveryKindOrRefusedInASentence)
{
    const TemporaryFolder folder;
    for (const std::string& kind : picture_extensions()) {
        const std::string bytes = sound_pictures(kind).front(), name = "a." + kind;
        const GreyImage image = read_grey(folder, name, bytes);
        EXPECT_EQ(image.values.size(), static_cast<std::size_t>(image.size_px.x) *
                                           static_cast<std::size_t>(image.size_px.y));
        try {
            read_grey(folder, name, bytes.substr(0, bytes.size() / 2));
        } catch (const Rejected& refused) {
            EXPECT_THAT(refused.what(), ::testing::HasSubstr("this "));
        }
    }
}

TEST(GreyImages, AreRefusedWhereTheyAreTooLarge)
{
    const TemporaryFolder folder;
    Image one;
    one.size_px = {1, 1};
    one.rgba = {9, 9, 9, 255};
    std::string bytes = encoded_image(one, ".png");
    for (const std::size_t side : {16, 20}) // of the head: 30000 x 30000
        bytes.replace(side, 4, std::string("\x00\x00\x75\x30", 4));
    try {
        read_grey(folder, "large.png", bytes);
        ADD_FAILURE() << "read";
    } catch (const Rejected& refused) {
        EXPECT_THAT(refused.what(), ::testing::HasSubstr("30000 x 30000"));
    }
    EXPECT_THROW(read_grey_image(folder.file("none.png")), Rejected);
}

} // namespace
} // namespace trivar
