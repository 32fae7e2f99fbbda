// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/tiles.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::Rig;

// A ball, and a strip that is selected to lay strands with.
struct StrandsRig : Rig {
    StrandsRig()
    {
        AddSphere ball;
        ball.shape.radius = 1;
        EXPECT_TRUE(editor.session.run(ball));
        AddPlane strip;
        strip.shape = {.size = {0.2, 0.1}, .segments = {4, 2}};
        strip.transform.translation = {3, 0, 0};
        EXPECT_TRUE(editor.session.run(strip));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0, -5, 1};
        editor.session.view.camera.target = {0, 0, 0};
        key({'T'});
        dynamic_cast<TilesTool&>(editor.active_tool()).choose_brush(TileBrush::strand);
        wait();
    }
    void lay(glm::vec2 from, glm::vec2 to)
    {
        const glm::vec2 c = layout().view.center();
        move(c + from);
        wait();
        draw({c + from, c + to});
        wait();
    }
    const std::vector<Ref<TileStroke>>& strokes() const
    {
        return object(editor.session.committed(), 2).tiles->strokes;
    }
    glm::vec2 seen(const glm::dvec3& p_world)
    {
        return layout().view.lo + glm::vec2(project(editor.session.view.camera, p_world).p_px);
    }
};

TEST(StrandTool, LaysAStrandOfFewPointsInOneStep)
{
    StrandsRig rig;
    const std::size_t before = rig.steps();
    rig.lay({-70, 0}, {70, 10});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.strokes().size(), 1u);
    const TileStroke& stroke = *rig.strokes()[0];
    EXPECT_EQ(stroke.brush, TileBrush::strand);
    ASSERT_GE(stroke.samples.size(), 3u);
    for (std::size_t i = 1; i + 1 < stroke.samples.size(); ++i)
        EXPECT_GE(glm::distance(stroke.samples[i].at.p, stroke.samples[i - 1].at.p),
                  0.99 * stroke.size);
}

TEST(StrandTool, DragsAPointOfAStrandInOneStep)
{
    StrandsRig rig;
    rig.lay({-70, 0}, {70, 10});
    const std::size_t before = rig.steps();
    const TileStroke was = *rig.strokes()[0];
    const std::size_t middle = was.samples.size() / 2;
    const glm::vec2 at = rig.seen(was.samples[middle].at.p);
    rig.move(at);
    rig.wait();
    rig.hold(ui::key_left_control); // without its neighbours
    rig.draw({at, at + glm::vec2(0, -12), at + glm::vec2(0, -25)});
    rig.hold(ui::key_left_control, false);
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.strokes().size(), 1u);
    const TileStroke alone = *rig.strokes()[0];
    ASSERT_EQ(alone.samples.size(), was.samples.size());
    for (std::size_t i = 0; i < alone.samples.size(); ++i)
        EXPECT_EQ(alone.samples[i] == was.samples[i], i != middle);
    EXPECT_GT(alone.samples[middle].at.p.z, was.samples[middle].at.p.z + 0.05);
    EXPECT_NEAR(glm::length(alone.samples[middle].at.p), 1, 0.01);
    rig.editor.session.undo();
    rig.wait();
    rig.move(at);
    rig.wait();
    rig.draw({at, at + glm::vec2(0, -12), at + glm::vec2(0, -25)});
    rig.wait();
    const TileStroke& soft = *rig.strokes()[0];
    ASSERT_EQ(soft.samples.size(), was.samples.size());
    EXPECT_NEAR(glm::distance(soft.samples[middle].at.p, alone.samples[middle].at.p), 0, 1e-6);
    EXPECT_GT(soft.samples[middle - 1].at.p.z, was.samples[middle - 1].at.p.z + 0.01);
    for (const TileSample& each : soft.samples) EXPECT_NEAR(glm::length(each.at.p), 1, 0.01);
}

TEST(StrandTool, LetsGoOfAPointWithoutATrace)
{
    StrandsRig rig;
    rig.lay({-70, 0}, {70, 10});
    const std::size_t before = rig.steps();
    const TileStroke was = *rig.strokes()[0];
    const glm::vec2 at = rig.seen(was.samples[1].at.p);
    rig.move(at);
    rig.wait();
    rig.draw({at, at + glm::vec2(0, -25)}, false);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(*rig.strokes()[0], was);
}

TEST(StrandTool, TakesDroppedModelsAsTiles)
{
    StrandsRig rig;
    testing::TemporaryFolder folder;
    const std::string file = folder.file("tile_rope.glb");
    std::filesystem::copy_file(TRIVAR_BINARY_DIR "/assets/models/tile_rope.glb", file);
    const std::size_t before = rig.steps();
    EXPECT_TRUE(drop_tiles(rig.editor, {file}));
    EXPECT_EQ(rig.steps(), before); // it is read by the next stroke
    EXPECT_EQ(rig.editor.tool_models()->chosen_models(rig.editor.session),
              std::vector<std::string>{file});
    // The library is there when the program is opened again.
    EXPECT_EQ(preferences_from(text_of(rig.editor.preferences)).library_tiles,
              std::vector<std::string>{file});
    EXPECT_TRUE(drop_tiles(rig.editor, {file}));
    EXPECT_EQ(rig.editor.preferences.library_tiles.size(), 1u);
    EXPECT_FALSE(drop_tiles(rig.editor, {folder.file("scene.trivar")}));
    rig.key({ui::key_escape}); // another tool
    EXPECT_FALSE(drop_tiles(rig.editor, {file}));
}

TEST(StrandTool, SaysWhereATileOfTheLibraryWasThatIsGone)
{
    StrandsRig rig;
    testing::TemporaryFolder folder;
    const std::string file = folder.file("tile_rope.glb");
    rig.editor.preferences.library_tiles = {file};
    const std::size_t said = rig.editor.session.notices.all().size();
    EXPECT_TRUE(drop_tiles(rig.editor, {file})); // as a click on it would choose it
    ASSERT_EQ(rig.editor.session.notices.all().size(), said + 1);
    const auto& notice = rig.editor.session.notices.all().back();
    EXPECT_EQ(notice.title, "tile_rope.glb is missing");
    EXPECT_THAT(notice.body, ::testing::HasSubstr(file));
    EXPECT_NE(rig.editor.tool_models()->chosen_models(rig.editor.session),
              std::vector<std::string>{file});
    ASSERT_EQ(notice.actions.size(), 1u);
    notice.actions[0].act();
    EXPECT_TRUE(rig.editor.preferences.library_tiles.empty());
}

} // namespace
} // namespace trivar
