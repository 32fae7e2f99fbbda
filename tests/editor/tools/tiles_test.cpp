// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/rig.h"

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
            all += part.rest->vertex_count();
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

TEST(TilesTool, ErasesWithShift)
{
    TilesRig rig;
    rig.paint();
    const std::size_t painted = rig.vertices();
    rig.hold(ui::key_left_shift);
    rig.paint();
    rig.hold(ui::key_left_shift, false);
    ASSERT_EQ(rig.tiles()->strokes.size(), 2u);
    EXPECT_EQ(rig.tiles()->strokes[1]->brush, TileBrush::erase);
    EXPECT_LT(rig.vertices(), painted);
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

} // namespace
} // namespace trivar
