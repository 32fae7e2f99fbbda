// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "editor/actions/placement_actions.h"
#include "editor/tools/tiles/tiles.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::Rig;

// A ball, and a small box that is selected to paint with.
struct TilesRig : Rig {
    TilesRig()
    {
        AddSphere ball;
        ball.shape.radius = 1;
        EXPECT_TRUE(editor.session.run(ball));
        AddBox stud;
        stud.shape = {.size = {0.2, 0.2, 0.1}, .segments = {1, 1, 1}};
        stud.transform.translation = {3, 0, 0};
        EXPECT_TRUE(editor.session.run(stud));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0, -5, 1};
        editor.session.view.camera.target = {0, 0, 0};
        key({'T'});
        wait();
    }
    // Drags from left to right over the front of the ball.
    void paint(bool let_go = true)
    {
        const glm::vec2 c = layout().view.center();
        move(c + glm::vec2(-60, 0));
        wait();
        draw({c + glm::vec2(-60, 0), c + glm::vec2(60, 10)}, let_go);
        wait();
    }
    const std::optional<Tiling>& tiles(Id id = 2) const
    {
        return object(editor.session.committed(), id).tiles;
    }
    std::size_t vertices(Id id = 2) const
    {
        std::size_t all = 0;
        for (const Part& part : editor.session.evaluated().objects.at(id)->parts)
            all += part.vertex_count();
        return all;
    }
};

TEST(TilesTool, PaintsTheSelectedObjectOntoWhatIsUnderTheBrush)
{
    TilesRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Tiles");
    const std::size_t before = rig.steps(), single = rig.vertices();
    rig.paint();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.tiles());
    EXPECT_EQ(rig.tiles()->base, 1);
    ASSERT_EQ(rig.tiles()->strokes.size(), 1u);
    EXPECT_GE(rig.tiles()->strokes[0]->samples.size(), 5u);
    for (const TileSample& each : rig.tiles()->strokes[0]->samples) {
        EXPECT_NEAR(glm::length(each.at.p), 1, 0.01);
        EXPECT_LT(each.at.p.y, -0.5); // on the side that is seen
    }
    EXPECT_GE(rig.vertices(), 4 * single);
    rig.paint(); // adds to the same layer, with other random numbers
    ASSERT_EQ(rig.tiles()->strokes.size(), 2u);
    EXPECT_NE(rig.tiles()->strokes[0]->seed, rig.tiles()->strokes[1]->seed);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.tiles());
    EXPECT_EQ(rig.vertices(), single);
}

TEST(TilesTool, ShowsWhatItPaintsAndLeavesNoTraceWhenItIsCancelled)
{
    TilesRig rig;
    const std::size_t before = rig.steps(), single = rig.vertices();
    rig.paint(false);
    EXPECT_GE(rig.vertices(), 4 * single);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.vertices(), single);
    EXPECT_FALSE(rig.tiles());
}

TEST(TilesTool, PaintsStraightWithShift)
{
    TilesRig rig;
    const glm::vec2 c = rig.layout().view.center();
    rig.move(c + glm::vec2(-60, 0));
    rig.wait();
    rig.hold(ui::key_left_shift);
    rig.draw({c + glm::vec2(-60, 0), c + glm::vec2(0, -50), c + glm::vec2(60, 0)});
    rig.hold(ui::key_left_shift, false);
    rig.wait();
    ASSERT_TRUE(rig.tiles());
    const auto& samples = rig.tiles()->strokes[0]->samples;
    EXPECT_GE(samples.size(), 5u);
    const Camera& camera = rig.editor.session.view.camera;
    const double height = project(camera, samples.front().at.p).p_px.y;
    for (const TileSample& each : samples)
        EXPECT_NEAR(project(camera, each.at.p).p_px.y, height, 1);
}

TEST(TilesTool, ErasesWithControl)
{
    TilesRig rig;
    rig.paint();
    const std::size_t painted = rig.vertices();
    rig.hold(ui::key_left_control);
    rig.paint();
    rig.hold(ui::key_left_control, false);
    ASSERT_EQ(rig.tiles()->strokes.size(), 2u);
    EXPECT_EQ(rig.tiles()->strokes[1]->brush, TileBrush::erase);
    EXPECT_LT(rig.vertices(), painted);
}

TEST(TilesTool, CoversWhatIsClickedInOneStepAndUncoversItWithControl)
{
    TilesRig rig;
    auto& tool = dynamic_cast<TilesTool&>(rig.editor.active_tool());
    tool.choose_cover({.pattern = TilePattern::brick, .per_face = 2});
    const std::size_t before = rig.steps(), single = rig.vertices();
    const glm::vec2 c = rig.layout().view.center();
    const auto click_base = [&] {
        rig.move(c);
        rig.wait();
        rig.click(c);
        rig.wait();
    };
    click_base();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.tiles());
    EXPECT_EQ(rig.tiles()->base, 1);
    EXPECT_EQ(rig.tiles()->cover.pattern, TilePattern::brick);
    EXPECT_GT(rig.tiles()->cover.size, 0);
    EXPECT_TRUE(rig.tiles()->strokes.empty());
    EXPECT_GE(rig.vertices(), 1000 * single);
    click_base();
    EXPECT_EQ(rig.steps(), before + 1) << "it is laid already";
    rig.hold(ui::key_left_control);
    click_base();
    rig.hold(ui::key_left_control, false);
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_EQ(rig.tiles()->cover.pattern, TilePattern::none);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.tiles());
}

TEST(CoverAction, CoversTheActiveObjectWithTheOtherOne)
{
    TilesRig rig;
    EXPECT_FALSE(is_enabled(rig.editor, action(rig.editor, cover_action)));
    rig.editor.session.selected.set({2, 1});
    rig.frames();
    ASSERT_TRUE(is_enabled(rig.editor, action(rig.editor, cover_action)));
    const std::size_t before = rig.steps();
    action(rig.editor, cover_action).run(rig.editor);
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.tiles());
    EXPECT_EQ(rig.tiles()->base, 1);
    EXPECT_NEAR(rig.tiles()->cover.size, 2.0 / 25, 0.01); // the ball is 2 m wide
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(2)->shows_nothing());
    rig.editor.session.selected.set({1, 2}); // what lies on it cannot be covered by it
    rig.frames();
    action(rig.editor, cover_action).run(rig.editor);
    EXPECT_EQ(rig.steps(), before + 1);
}

TEST(TilesTool, PaintsNothingWithoutSomethingToPaintWith)
{
    TilesRig rig;
    rig.editor.session.selected = {};
    const std::size_t before = rig.steps();
    rig.paint();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.editor.session.selected, 1); // the click selected what was under it
    rig.paint();                               // onto itself: there is nothing else under the brush
    EXPECT_EQ(rig.steps(), before);
    EXPECT_FALSE(rig.tiles(1));
}

// The library's models are all a small box.
struct TileLibraryRig : TilesRig {
    TileLibraryRig()
    {
        editor.files.write_model_to(folder.file("tile_thorn.glb"));
        wait();
        editor.session.undo();
        editor.files.own_models_folder = folder.path().string();
        editor.session.selected = {};
        editor.session.notices.clear(); // they stand over what is painted on
        wait();
    }
    // Clicks the first picture of the library.
    void choose_first()
    {
        const ui::Rect view = layout().view;
        click(view.hi * glm::vec2(0, 1) + glm::vec2(view.lo.x, 0) + first_from_corner());
        wait();
    }
    glm::vec2 first_from_corner() const { return {60, -75}; }
    testing::TemporaryFolder folder;
};

TEST(TileLibrary, PaintsWithAModelThatWasNotInTheScene)
{
    TileLibraryRig rig;
    ASSERT_EQ(rig.editor.session.committed().objects.size(), 1u);
    rig.choose_first();
    EXPECT_EQ(rig.editor.tool_models()->chosen_models(rig.editor.session),
              std::vector<std::string>{rig.folder.file("tile_thorn.glb")});
    const std::size_t before = rig.steps();
    rig.paint();
    EXPECT_EQ(rig.steps(), before + 1); // imports and paints
    const Id layer = rig.editor.session.selected;
    ASSERT_NE(layer, 0);
    ASSERT_TRUE(rig.tiles(layer));
    EXPECT_EQ(rig.tiles(layer)->base, 1);
    rig.paint(); // goes on with the layer
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_EQ(rig.tiles(layer)->strokes.size(), 2u);
    rig.choose_first();
    rig.paint(); // begins another one
    EXPECT_EQ(rig.steps(), before + 3);
    EXPECT_NE(rig.editor.session.selected, layer);
}

TEST(TileLibrary, TheFirstStrokeIsUndoneWithItsModelAndCanBePaintedAgain)
{
    TileLibraryRig rig;
    rig.choose_first();
    const std::size_t before = rig.steps();
    rig.paint(false);
    EXPECT_EQ(rig.editor.session.committed().objects.size(), 1u);
    EXPECT_EQ(rig.editor.session.document().objects.size(), 2u); // it is seen already
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
    EXPECT_EQ(rig.steps(), before);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames();
    rig.paint();
    ASSERT_EQ(rig.editor.session.committed().objects.size(), 2u);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.editor.session.committed().objects.size(), 1u);
    rig.paint(); // with what was undone
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.editor.session.committed().objects.size(), 2u);
    EXPECT_TRUE(rig.tiles(rig.editor.session.selected));
}

TEST(TilesTool, MirrorsItsTilesWhereItsStrokesAreMirrored)
{
    TilesRig rig;
    auto& tool = dynamic_cast<TilesTool&>(rig.editor.active_tool());
    tool.choose_brush(TileBrush::line);
    rig.paint();
    tool.choose_mirror(TileMirror::z);
    rig.paint();
    tool.choose_brush(TileBrush::comb);
    rig.paint();
    ASSERT_EQ(rig.tiles()->strokes.size(), 3u);
    EXPECT_FALSE(rig.tiles()->strokes[0]->mirrors_tiles);
    EXPECT_TRUE(rig.tiles()->strokes[1]->mirrors_tiles);
    EXPECT_FALSE(rig.tiles()->strokes[2]->mirrors_tiles); // it lays none
    EXPECT_EQ(rig.editor.session.evaluated().objects.at(2)->parts.size(), 2u);
}

TEST(TileLibrary, PaintsAMixOfSeveral)
{
    TileLibraryRig rig;
    const std::string thorn = rig.folder.file("tile_thorn.glb"),
                      other = rig.folder.file("other.glb"), third = rig.folder.file("third.glb");
    std::filesystem::copy_file(thorn, other);
    std::filesystem::copy_file(thorn, third);
    Session& session = rig.editor.session;
    ModelTool& tool = *rig.editor.tool_models();
    tool.choose_model(session, thorn, false);
    tool.choose_model(session, third, true);
    tool.choose_model(session, other, true);
    tool.choose_model(session, third, true); // not after all
    EXPECT_EQ(tool.chosen_models(session), (std::vector<std::string>{thorn, other}));
    const std::size_t before = rig.steps();
    rig.paint();
    EXPECT_EQ(rig.steps(), before + 1); // two imports and a stroke in one
    const Id layer = session.selected;
    ASSERT_TRUE(rig.tiles(layer));
    ASSERT_EQ(rig.tiles(layer)->others.size(), 1u);
    EXPECT_TRUE(object(session.document(), rig.tiles(layer)->others[0].object).hidden);
    EXPECT_EQ(tool.chosen_models(session).size(), 2u);
    // The layer takes one more.
    tool.choose_model(session, third, true);
    for (int i = 0; i < 10; ++i) rig.wait();
    EXPECT_EQ(session.selected, layer);
    EXPECT_EQ(rig.tiles(layer)->others.size(), 2u);
    EXPECT_EQ(rig.steps(), before + 2);
}

TEST(TileLibrary, ASelectedObjectTakesThePlaceOfWhatWasChosen)
{
    TileLibraryRig rig;
    rig.editor.tool_models()->choose_model(rig.editor.session, "elsewhere/thorn.glb", false);
    AddBox stud;
    stud.shape = {.size = {0.2, 0.2, 0.1}, .segments = {1, 1, 1}};
    ASSERT_TRUE(rig.editor.session.run(stud));
    const Id stud_id = rig.editor.session.committed().next_id - 1;
    rig.editor.session.selected = stud_id;
    rig.paint();
    EXPECT_TRUE(rig.tiles(stud_id));
}

TEST(TileLibrary, AFileThatCannotBeReadLeavesEverythingAsItWas)
{
    TileLibraryRig rig;
    const std::size_t before = rig.steps();
    rig.editor.tool_models()->choose_model(rig.editor.session, rig.folder.file("vanished.glb"),
                                           false);
    rig.paint();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

} // namespace
} // namespace trivar
