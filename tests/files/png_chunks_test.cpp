// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/png_chunks.h"

#include "core/base/rejected.h"
#include "core/files/pictures/image.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

std::string small_png()
{
    Image image;
    image.size_px = {9, 7};
    for (int i = 0; i < 9 * 7 * 4; ++i) image.rgba.push_back(static_cast<std::uint8_t>(37 * i));
    return encoded_image(image, ".png", {{"trivar:log", "abc"}});
}

TEST(PngChunks, OfAWholeFileAreRight)
{
    EXPECT_EQ(png_trouble(small_png()), "");
    EXPECT_EQ(png_trouble(small_png() + "and more"), "");
}

TEST(PngChunks, TellEveryChangedByteAndEveryEndBeforeTheEnd)
{
    const std::string whole = small_png();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ 0x10);
        EXPECT_NE(png_trouble(changed), "") << i;
        EXPECT_NE(png_trouble(whole.substr(0, i)), "") << i;
    }
}

TEST(PngChunks, RefuseAPictureWithoutAWordOfItsLibrary)
{
    std::string damaged = small_png();
    damaged[damaged.find("IDAT") + 9] ^= 1;
    ::testing::internal::CaptureStderr();
    std::string why;
    try {
        PictureReader().read_bytes(damaged, "a.png");
    } catch (const Rejected& refused) {
        why = refused.what();
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_THAT(why, HasSubstr("a.png: this PNG picture is damaged: its chunk IDAT differs"));
}

} // namespace
} // namespace trivar
