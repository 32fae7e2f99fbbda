// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/formats.h"
#include "core/files/pictures/image.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A material whose picture is named by a line, in a folder with "my t.png" and "2.png".
struct MtlOf {
    TemporaryFolder folder;
    Mtl mtl;

    explicit MtlOf(const std::string& lines)
    {
        for (const char* name : {"my t.png", "2.png"})
            write_image(checker_image(), folder.file(name));
        mtl = read_mtl({"newmtl a\n" + lines, "m.mtl", folder.path().string()});
    }
};

TEST(MtlReader, TakesThePicturesNameFromBehindItsOptions)
{
    for (const char* options :
         {"", "-colorspace sRGB", "-clamp on", "-clamp", "-blendu off -blendv on", "-bm 0.5",
          "-boost 2", "-cc on", "-imfchan r", "-mm 0 1", "-texres 512", "-type sphere", "-o 0 0 0",
          "-s 1 1 1", "-s 1 1", "-t 0", "-s", "-o 0 -s 1 1 1 -bm 1.0 -colorspace Non-Color"}) {
        const MtlOf read(std::string("map_Kd ") + options + "  my t.png\n");
        EXPECT_TRUE(read.mtl.materials[0].base_color_texture.image) << options;
        EXPECT_THAT(read.mtl.notices, IsEmpty()) << options;
    }
    EXPECT_TRUE(MtlOf("map_Kd -s 1 1 2.png").mtl.materials[0].base_color_texture.image);
}

TEST(MtlReader, FindsThePictureBehindAnOptionNobodyKnowsAndSaysSo)
{
    const MtlOf read("map_Kd -shine 1 of two my t.png\nmap_Ke -o 0.5 0 0 2.png\n");
    EXPECT_TRUE(read.mtl.materials[0].base_color_texture.image);
    EXPECT_TRUE(read.mtl.materials[0].emissive_texture.image);
    EXPECT_THAT(read.mtl.notices,
                ElementsAre("m.mtl: options of its pictures were left out: -o and -shine"));
}

TEST(MtlReader, TakesClampAndTheStrengthOfNormals)
{
    const Material m = MtlOf("map_Kd -clamp on 2.png\nnorm -bm 0.25 2.png\n").mtl.materials[0];
    EXPECT_FALSE(m.base_color_texture.repeat_u || m.base_color_texture.repeat_v);
    EXPECT_TRUE(m.normal_texture.repeat_u && m.normal_texture.repeat_v);
    EXPECT_EQ(m.normal_scale, 0.25f);
}

TEST(MtlReader, SaysWhatItLeftOutOnceForEachKind)
{
    const MtlOf read("map_Kd a.png\nmap_Ke -s 2 2 2 b.png\nnorm\nmap_Kd a.png\nKd one\nd x\n"
                     "map_Bump 2.png\ndisp 2.png\nmap_Bump 2.png\nmap_Ke MY T.png\n");
    EXPECT_THAT(read.mtl.notices,
                ElementsAre("m.mtl: line 6: Kd is 'one', which is not a number from -3.4e38 to "
                            "3.4e38; it was left out with 1 line more of its kind",
                            "m.mtl: 2 pictures are not in the model's folder: a.png (line 2) and "
                            "b.png (line 3)",
                            "m.mtl: line 4: a picture's file must be named there",
                            "m.mtl: 1 picture is named with other capitals than in the folder: my "
                            "t.png",
                            "m.mtl: the pictures of disp and map_Bump were left out; those of "
                            "map_Kd, map_Ke and norm are read",
                            "m.mtl: options of its pictures were left out: -s"));
}

} // namespace
} // namespace trivar
