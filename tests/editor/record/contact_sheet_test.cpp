// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/contact_sheet.h"

#include "core/base/rejected.h"
#include "core/files/pictures/image.h"
#include "editor/command_line/command_line.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <numeric>
#include <sstream>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr;

std::vector<int> up_to(int last)
{
    std::vector<int> frames(static_cast<std::size_t>(last));
    std::iota(frames.begin(), frames.end(), 1);
    return frames;
}

TEST(ContactSheet, HasTheFirstAndTheLastFrameAndOthersEvenlyBetween)
{
    EXPECT_THAT(evenly_chosen(up_to(12), 4), ElementsAre(1, 5, 8, 12));
    EXPECT_THAT(evenly_chosen(up_to(240), 6), ElementsAre(1, 49, 97, 144, 192, 240));
    EXPECT_THAT(evenly_chosen(up_to(3), 9), ElementsAre(1, 2, 3));
    EXPECT_THAT(evenly_chosen(up_to(3), 1), ElementsAre(1));
}

TEST(ContactSheet, PutsPicturesSideBySideRowByRow)
{
    std::vector<Image> pictures;
    for (std::uint8_t shade : {10, 20, 30}) {
        Image picture;
        picture.size_px = {4, 2};
        picture.rgba.assign(4 * 4 * 2, shade);
        pictures.push_back(picture);
    }
    const Image sheet = contact_sheet(pictures, 2);
    ASSERT_EQ(sheet.size_px, glm::ivec2(9, 5));
    const auto red = [&](int x, int y) { return sheet.rgba[std::size_t(4 * (y * 9 + x))]; };
    EXPECT_THAT((std::vector{red(0, 0), red(3, 1), red(5, 0), red(8, 1), red(0, 3), red(3, 4)}),
                ElementsAre(10, 10, 20, 20, 30, 30));
    EXPECT_EQ(red(4, 0), red(0, 2)); // gaps
    EXPECT_EQ(red(4, 0), red(8, 4)); // where a picture is lacking
}

struct Sheets : ::testing::Test {
    testing::TemporaryFolder folder;
    const std::string scene = folder.file("scene.trivar");
    std::ostringstream talk;
    Sheets()
    {
        SceneFile file = testing::typical_scene();
        file.save_as(scene);
    }
    Status render(const std::string& name, const std::vector<std::string>& more)
    {
        std::vector<std::string> all{"render", scene,   "--out",     folder.file(name),
                                     "--size", "64x36", "--quality", "draft"};
        all.insert(all.end(), more.begin(), more.end());
        std::ostringstream out;
        talk.str("");
        return run_program(all, {out, talk});
    }
};

TEST_F(Sheets, AreTheFramesThatRenderDraws)
{
    ASSERT_EQ(render("sheet.png", {"--frames", "1:12", "--sheet", "2x2"}), Status::done)
        << talk.str();
    std::vector<Image> frames;
    ASSERT_EQ(render("a.##.png", {"--frames", "1:12"}), Status::done);
    for (const char* frame : {"01", "05", "08", "12"})
        frames.push_back(read_image(folder.file(std::string("a.") + frame + ".png")));
    EXPECT_EQ(read_image(folder.file("sheet.png")).rgba, contact_sheet(frames, 2).rgba);
}

TEST_F(Sheets, AreRefusedInASentence)
{
    for (const char* grid : {"3", "3x", "x2", "0x2", "3x-1", "65x1", "3x2x1", " 3x2"}) {
        EXPECT_NE(render("sheet.png", {"--frames", "1:12", "--sheet", grid}), Status::done) << grid;
        EXPECT_THAT(talk.str(), HasSubstr("--sheet")) << grid;
    }
    EXPECT_NE(render("sheet.txt", {"--frames", "1:12", "--sheet", "2x2"}), Status::done);
    EXPECT_NE(render("sheet.png", {"--frames", "1:12", "--sheet", "2x2", "--resume"}),
              Status::done);
    EXPECT_FALSE(std::filesystem::exists(folder.file("sheet.png")));
}

} // namespace
} // namespace trivar
