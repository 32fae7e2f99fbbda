// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/tiles/tiles.h"
#include "core/files/pictures/image.h"
#include "editor/actions/actions.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::Rig;

// A ball that is filled with small boxes, which are selected.
struct MaskRig : Rig {
    MaskRig()
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 1}}));
        EXPECT_TRUE(editor.session.run(
            AddBox{.shape = {.size = {0.2, 0.2, 0.1}, .segments = {1, 1, 1}}, .transform = {}}));
        TileStroke fill;
        fill.brush = TileBrush::fill;
        fill.size = 0.2;
        fill.samples = {{{{0, -1, 0}, {0, -1, 0}}}};
        EXPECT_TRUE(editor.session.run(PaintTiles{2, 1, fill}));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0, -5, 1};
        editor.session.view.camera.target = {0, 0, 0};
        key({'M'});
        wait();
    }
    void drag(glm::vec2 from, glm::vec2 to)
    {
        const glm::vec2 c = layout().view.center();
        move(c + from);
        wait();
        draw({c + from, c + to});
        wait();
    }
    const std::vector<TileMask>& masks() const
    {
        return object(editor.session.committed(), 2).tiles->masks;
    }
    std::size_t vertices() const
    {
        std::size_t all = 0;
        for (const Part& part : editor.session.evaluated().objects.at(2)->parts)
            all += part.vertex_count();
        return all;
    }
};

TEST(MaskTool, LaysAGradientFromWhereADragBeginsToWhereItEnds)
{
    MaskRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Mask");
    const std::size_t before = rig.steps(), all = rig.vertices();
    rig.drag({0, 50}, {0, -60});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.masks().size(), 1u);
    const TileMask& mask = rig.masks()[0];
    EXPECT_EQ(mask.from, MaskFrom::line);
    EXPECT_LT(mask.begin.z + 0.2, mask.end.z);
    EXPECT_NEAR(glm::length(mask.begin), 1, 0.01);
    EXPECT_LT(rig.vertices(), all);
    EXPECT_GT(rig.vertices(), 0u);
    rig.drag({-50, 0}, {50, 0}); // takes its place
    ASSERT_EQ(rig.masks().size(), 1u);
    EXPECT_LT(rig.masks()[0].begin.x, rig.masks()[0].end.x);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_THAT(rig.masks(), ::testing::IsEmpty());
    EXPECT_EQ(rig.vertices(), all);
}

TEST(MaskTool, TakesTheTilesForAHiddenBase)
{
    MaskRig rig;
    EXPECT_TRUE(rig.editor.session.run(Hide{{1}}));
    rig.editor.session.selected = 2;
    rig.wait();
    rig.drag({0, 40}, {0, -40});
    ASSERT_EQ(rig.masks().size(), 1u);
    EXPECT_LT(rig.masks()[0].begin.z, rig.masks()[0].end.z);
}

TEST(MaskTool, LeavesNoTraceWhenItIsCancelled)
{
    MaskRig rig;
    const std::size_t before = rig.steps(), all = rig.vertices();
    const glm::vec2 c = rig.layout().view.center();
    rig.move(c);
    rig.wait();
    rig.draw({c, c + glm::vec2(40, 0)}, false);
    rig.wait();
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.vertices(), all);
}

TEST(DroppedPictures, MaskALayerAndDisplaceAnythingElse)
{
    const testing::TemporaryFolder folder;
    Image image;
    image.size_px = {2, 2};
    for (const int grey : {0, 255, 255, 0})
        for (const int channel : {grey, grey, grey, 255})
            image.rgba.push_back(static_cast<std::uint8_t>(channel));
    write_image(image, folder.file("checks.png"));
    MaskRig rig;
    rig.editor.files.take_dropped({folder.file("checks.png")});
    rig.wait();
    ASSERT_EQ(rig.masks().size(), 1u);
    EXPECT_EQ(rig.masks()[0].from, MaskFrom::image);
    EXPECT_FALSE(rig.masks()[0].image_hash.empty());
    rig.editor.session.selected = 1;
    rig.editor.files.take_dropped({folder.file("checks.png")});
    rig.wait();
    ASSERT_TRUE(rig.editor.session.committed().objects.contains(3));
    EXPECT_TRUE(object(rig.editor.session.committed(), 1).hidden);
    rig.editor.session.selected = {};
    const std::size_t steps = rig.steps();
    rig.editor.files.take_dropped({folder.file("checks.png")});
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_THAT(rig.editor.session.notices.all().back().body,
                ::testing::HasSubstr("Select an object"));
}

} // namespace
} // namespace trivar
