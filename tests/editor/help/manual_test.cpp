// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/manual.h"

#include "core/base/text.h"
#include "editor/actions/show_manual.h"
#include "editor/picture/stored_pictures.h"
#include "tests/editor/help/unknown_actions.h"
#include "tests/editor/rig.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig;
using enum ui::Run::Kind;

const std::string pages_folder = std::string(TRIVAR_SOURCE_DIR) + "/docs/manual";

std::vector<ui::Run> all_runs(const ManualPage& page)
{
    std::vector<ui::Run> runs;
    for (const Block& block : page.blocks) {
        runs.insert(runs.end(), block.runs.begin(), block.runs.end());
        for (const auto& cell : block.cells) runs.insert(runs.end(), cell.begin(), cell.end());
    }
    return runs;
}

TEST(Manual, HasThePageThatEachToolNames)
{
    const auto pages = manual_in(pages_folder);
    for (const auto& tool : all_tools())
        EXPECT_TRUE(page_of(pages, tool->facts().page))
            << tool->name() << ": " << tool->facts().page;
}

TEST(Manual, LeadsNowhereThatIsNotThereAndNamesNoActionThatIsNot)
{
    const Rig rig;
    const auto pages = manual_in(pages_folder);
    ASSERT_GE(pages.size(), 10u);
    EXPECT_EQ(pages.front().name, "start");
    EXPECT_EQ(pages.back().name, keys_page);
    for (const ManualPage& page : pages) {
        EXPECT_NE(page.title, page.name);
        for (const ui::Run& run : all_runs(page)) {
            EXPECT_THAT(testing::unknown_actions(rig.editor, run.text), IsEmpty()) << page.name;
            if (run.kind != link) continue;
            EXPECT_TRUE(page_of(pages, linked_page(run.target))) << page.name << run.target;
        }
        for (const Block& block : page.blocks) {
            if (block.kind != Block::Kind::picture) continue;
            EXPECT_TRUE(std::filesystem::exists(block.text)) << block.text;
        }
    }
}

TEST(Manual, FindsWordsWhateverTheirCaseAndTheTitleFirst)
{
    const std::vector<ManualPage> pages{
        {"a", "Place", blocks_of("Draw a *Stroke* here.")},
        {"b", "Other", blocks_of("one\n\n## Strokes here\n\ntwo strokes\n\nHere, a stroke")}};
    EXPECT_THAT(found_in(pages, "PLACE"), ::testing::SizeIs(1));
    const auto found = found_in(pages, "here stroke");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].words, "Draw a Stroke here.");
    EXPECT_EQ(found[1].block, 1u); // the heading
    EXPECT_THAT(found_in(pages, "nowhere"), IsEmpty());
}

TEST(Manual, OpensAtTheToolAtHandFollowsALinkAndGoesBack)
{
    Rig rig;
    rig.editor.memory.of<ManualPages>().folder = pages_folder;
    rig.frames();
    rig.key({'D'});
    rig.key({ui::key_f1});
    EXPECT_EQ(rig.editor.memory.of<ManualDialog>().page, "place");
    for (const ManualPage& page : rig.editor.memory.of<ManualPages>().pages) { // each is drawn
        show_manual(rig.editor, page.name);
        rig.frames();
    }
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.memory.of<ManualDialog>().open);
}

TEST(Manual, WithoutItsFilesStillHasTheKeys)
{
    Rig rig;
    rig.editor.memory.of<ManualPages>().folder = "/nowhere";
    rig.frames();
    rig.key({ui::key_f1});
    EXPECT_EQ(rig.editor.memory.of<ManualDialog>().page, keys_page);
}

TEST(Markdown, GivesTheBlocksOfAPage)
{
    const auto blocks = blocks_of("# Title\n\nPress `Ctrl Z` or **undo**,\nthen [go](on.md).\n\n"
                                  "1. one\n2. two\n   * deep\n\n| a | b |\n|---|---|\n| c | d |\n\n"
                                  "```\nx = 1\ny = 2\n```\n\n![A cat](cat.png)\n");
    std::vector<Block::Kind> kinds;
    for (const Block& block : blocks) kinds.push_back(block.kind);
    using enum Block::Kind;
    EXPECT_THAT(kinds, ElementsAre(heading, paragraph, item, item, item, row, row, code, picture));
    EXPECT_THAT(blocks[1].runs, ElementsAre(ui::Run{plain, "Press "}, ui::Run{key, "Ctrl Z"},
                                            ui::Run{plain, " or "}, ui::Run{strong, "undo"},
                                            ui::Run{plain, ", then "}, ui::Run{link, "go", "on.md"},
                                            ui::Run{plain, "."}));
    EXPECT_EQ(blocks[3].number, 2);
    EXPECT_EQ(blocks[4].level, 2);
    EXPECT_TRUE(blocks[5].header);
    EXPECT_EQ(plain_text(blocks[6].cells[1]), "d");
    EXPECT_EQ(blocks[7].text, "x = 1\ny = 2\n");
    EXPECT_EQ(blocks[8].text, "cat.png");
}

TEST(StoredPictures, AreShrunkByWholeNumbersToTheirMeans)
{
    Image image;
    image.size_px = {4, 2};
    for (int i = 0; i < 8; ++i)
        for (const int channel : {i * 10, 0, 255, 255})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    const Image small = shrunk(image, 2);
    EXPECT_EQ(small.size_px, glm::ivec2(2, 1));
    EXPECT_THAT(small.rgba, ElementsAre(25, 0, 255, 255, 45, 0, 255, 255));
    EXPECT_EQ(shrunk(image, 3).size_px, image.size_px);
}

} // namespace
} // namespace trivar
