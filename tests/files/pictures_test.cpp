// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/pictures/decoder_process.h"
#include "core/files/pictures/image.h"
#include "core/files/pictures/kinds.h"
#include "tests/fuzz/pictures_campaign.h"
#include "tests/fuzz/sound_pictures.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>
#include <iterator>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

std::string refusal_of_picture(const std::string& bytes, const std::string& name)
{
    try {
        PictureReader().read_bytes(bytes, name);
        return "read";
    } catch (const Rejected& refused) {
        return refused.what();
    }
}

class PictureKinds : public ::testing::TestWithParam<std::string> {
protected:
    std::string name() const { return "a." + GetParam(); }
};

TEST_P(PictureKinds, HaveTheSizeThatTheirHeadsSay)
{
    PictureReader reader;
    for (const std::string& bytes : sound_pictures(GetParam())) {
        const glm::ivec2 size_px = picture_size(bytes, name());
        const Image image = reader.read_bytes(bytes, name());
        EXPECT_EQ(image.size_px, size_px);
        EXPECT_EQ(image.rgba.size(), 4u * static_cast<std::size_t>(size_px.x * size_px.y));
        EXPECT_NO_THROW(picture_head(bytes, name(), Look::whole));
    }
}

TEST_P(PictureKinds, AreReadAsAWholeOrNotAtAllWhereTheyAreCutOff)
{
    PictureReader reader;
    const std::string whole = sound_pictures(GetParam()).front();
    const Image image = reader.read_bytes(whole, name());
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 300) try {
            EXPECT_EQ(reader.read_bytes(whole.substr(0, length), name()).rgba, image.rgba)
                << length << " of " << whole.size();
        } catch (const Rejected& refused) {
            EXPECT_THAT(refused.what(), ::testing::StartsWith(name() + ": this "));
        }
}

TEST_P(PictureKinds, AreReadOrRefusedInASentenceWhereTheyAreDamaged)
{
    PictureReader reader;
    const PicturesCampaign campaign(GetParam());
    int read = 0;
    ::testing::internal::CaptureStderr();
    for (int number = 0; number < 100; ++number)
        EXPECT_NO_THROW(read += use_picture(campaign.damaged(1, number), reader).empty()) << number;
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_GT(read, 0) << "some damage should be small";
}
INSTANTIATE_TEST_SUITE_P(Kinds, PictureKinds, ::testing::ValuesIn(picture_extensions()),
                         [](const auto& kind) { return kind.param; });

TEST(Pictures, OfUnknownKindsAreToldTheKnownOnes)
{
    EXPECT_THAT(refusal_of_picture("%PDF", "a.png"), HasSubstr("a.png: this is not a picture"));
    EXPECT_THAT(refusal_of_picture("", "a.png"), HasSubstr("PNG, JPEG, WebP"));
}

TEST(Pictures, WithAColourWithoutBitsAreRefused)
{
    std::string dds = sound_pictures("dds").back(); // plain pixels, masks from byte 92 on
    EXPECT_EQ(refusal_of_picture(dds, "a.dds"), "read");
    dds.replace(96, 4, 4, '\0');
    EXPECT_THAT(refusal_of_picture(dds, "a.png"), HasSubstr("a.png: this DDS picture is damaged"));
}

TEST(Pictures, WhoseHeadDeclaresMoreThanThereIsAreRefusedForThat)
{
    std::string exr = sound_pictures("exr").front();
    exr.replace(exr.find("box2i") + 6, 4, little(0x47000010, 4)); // the length of a window
    EXPECT_THAT(refusal_of_picture(exr, "a.exr"), HasSubstr("cut off after"));
    std::string bmp = sound_pictures("bmp").front();
    bmp.replace(18, 8, little(16000, 4) + little(16000, 4));
    EXPECT_THAT(refusal_of_picture(bmp, "a.bmp"),
                HasSubstr("cannot hold the 16000 x 16000 pixels"));
    bmp.replace(18, 4, little(0x80000000, 4));
    EXPECT_THAT(refusal_of_picture(bmp, "a.bmp"), HasSubstr("each side must have 1 to 16384"));
}

// The decoder fails where a table of colours begins beyond the numbers of its pixels.
TEST(Pictures, WhoseDecoderFailsLeaveTheNextToBeRead)
{
    const std::string whole = sound_pictures("tga").front();
    std::string bad = whole;
    bad.replace(3, 2, "\xff\xff");
    PictureReader reader;
    const Image image = reader.read_bytes(whole, "a.tga");
    for (int i = 0; i < 2; ++i) {
        try {
            reader.read_bytes(bad, "b.tga");
        } catch (const Rejected& refused) {
            EXPECT_THAT(refused.what(), HasSubstr("b.tga: this TGA picture is damaged"));
        }
        EXPECT_EQ(reader.read_bytes(whole, "a.tga").rgba, image.rgba);
    }
}

TEST(Pictures, DecodedApartTakeNoMoreMemoryThanTheyMay)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers reserve memory themselves";
#endif
    Image image;
    image.size_px = {4096, 4096};
    image.rgba.assign(std::size_t{4} << 24, 77);
    const std::string tga = encoded_image(image, ".tga", {{"compression", "rle"}});
    DecoderProcess decoder;
    const DecodeTask task{tga, "targa", image.size_px, {}};
    const auto decode = [&](std::uint64_t memory_bytes) {
        return decoder.decode(task, {memory_bytes, 60}, [](auto) {}).whole;
    };
    EXPECT_TRUE(decode(std::uint64_t{200} << 20));
    EXPECT_FALSE(decoder.ended());
    EXPECT_THROW(decode(std::uint64_t{16} << 20), Rejected);
    EXPECT_TRUE(decoder.ended());
}

TEST(Jpeg, IsWholeWithoutItsEndAndNotWithoutAPartOfItsPixels)
{
    const std::string jpeg = sound_pictures("jpg").front();
    const Image image = PictureReader().read_bytes(jpeg, "a.jpg");
    EXPECT_EQ(PictureReader().read_bytes(jpeg.substr(0, jpeg.size() - 2), "a.jpg").rgba,
              image.rgba);
    EXPECT_THAT(refusal_of_picture(jpeg.substr(0, jpeg.size() - 100), "a.jpg"),
                HasSubstr("a.jpg: this JPEG picture is cut off after"));
}

TEST(Png, IsRefusedWithoutAWordWherePixelsAreDamagedAndItsChecksumsRight)
{
    std::string png = sound_pictures("png").back();
    const std::size_t pixels = png.find("IDAT");
    const std::size_t length = png.find("IEND") - 8 - (pixels + 4);
    png[pixels + 4 + length / 2] ^= 0x55;
    png.replace(pixels + 4 + length, 4, big(png_checksum(png.substr(pixels, 4 + length)), 4));
    ::testing::internal::CaptureStderr();
    EXPECT_THAT(refusal_of_picture(png, "a.png"), HasSubstr("rows of pixels"));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Png, InPassesHasItsPixelsWhereTheyBelong)
{
    const std::string png = sound_pictures("png").front(); // pass 7 has rows 1, 3, 5 and 7
    const Image image = PictureReader().read_bytes(png, "a.png");
    ASSERT_EQ(image.size_px, glm::ivec2(8, 8));
    for (std::size_t x = 0; x < 8; ++x) {
        const auto gray = static_cast<std::uint8_t>(20 * 1 + 30 * x);
        EXPECT_EQ(image.rgba[4 * (3 * 8 + x)], gray);
        EXPECT_EQ(image.rgba[4 * (3 * 8 + x) + 3], 255);
    }
}

TEST(Png, OfSixteenBitsComesBackWithItsBitsAndWords)
{
    const TemporaryFolder folder;
    DeepImage deep;
    deep.size_px = {3, 2};
    for (int i = 0; i < 24; ++i) deep.rgba.push_back(static_cast<std::uint16_t>(257 * 10 * i));
    const ImageTags tags{{"trivar:frame", "7"}, {"trivar:log", "abc"}};
    write_file(folder.file("a.png"), encoded_image(deep, ".png", tags));
    const ImageHead head =
        PictureReader().head(folder.file("a.png"), {"trivar:frame", "none", "trivar:log"});
    EXPECT_EQ(head.bits, 16);
    EXPECT_EQ(head.tags, tags);
    const Image image = read_image(folder.file("a.png"));
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(image.rgba[i], 10 * i);
}

// The slow library is loaded only for formats that need it.
TEST(Pictures, InPngAndJpegAreReadAndPngWrittenWithoutTheLibraryForTheOthers)
{
    const auto is_loaded = [] {
        std::ifstream maps("/proc/self/maps");
        const std::string all(std::istreambuf_iterator<char>(maps), {});
        return all.find("libOpenImageIO") != all.npos;
    };
    if (is_loaded()) GTEST_SKIP() << "another test of this process loaded it";
    const std::string png = sound_pictures("png").back();
    Image image = PictureReader().read_bytes(png, "a.png");
    EXPECT_EQ(PictureReader().read_bytes(encoded_image(image, ".png"), "a.png").rgba, image.rgba);
    EXPECT_FALSE(is_loaded());
}

} // namespace
} // namespace trivar
