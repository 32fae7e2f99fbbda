// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_tiles.h"
#include "editor/picture/limit_colors.h"
#include "editor/session/session_facts.h"
#include "editor/tools/tiles/tiles.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

// A ball, and a row of three flat studs on its front, seen from there.
struct HandRig : testing::Rig {
    HandRig()
    {
        AddSphere ball;
        ball.shape = {.radius = 1, .segments = 48, .rings = 24};
        EXPECT_TRUE(editor.session.run(ball));
        AddBox stud;
        stud.shape = {.size = {0.2, 0.2, 0.04}, .segments = {1, 1, 1}};
        EXPECT_TRUE(editor.session.run(stud));
        TileStroke row;
        row.brush = TileBrush::line;
        for (int i = 0; i <= 20; ++i) {
            const double angle = 0.33 * (i - 10) / 10.0;
            const glm::dvec3 n(std::sin(angle), -std::cos(angle), 0);
            row.samples.push_back({{n, n}, 0.1 * i, 1});
        }
        row.size = 0.3;
        EXPECT_TRUE(editor.session.run(PaintTiles{2, 1, row, {}}));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0, -5, 0};
        editor.session.view.camera.target = {0, 0, 0};
        key({'T'});
        tool().choose_brush(TileBrush::grab);
        wait();
    }
    TilesTool& tool() { return dynamic_cast<TilesTool&>(editor.active_tool()); }
    const Tiling& tiles() const { return *object(editor.session.committed(), 2).tiles; }
    std::vector<PlacedTile> placed() const
    {
        std::vector<PlacedTile> out;
        for (const Part& part : editor.session.evaluated().objects.at(2)->parts)
            out.insert(out.end(), part.tiles->tiles->begin(), part.tiles->tiles->end());
        return out;
    }
    glm::vec2 seen(const PlacedTile& tile) const
    {
        const glm::dvec3 p = tile_point(tile.patch, {0.5, 0.5, 0}).p;
        return layout().view.lo + glm::vec2(project(editor.session.view.camera, p).p_px);
    }
    void take(std::initializer_list<std::size_t> which)
    {
        const std::vector<PlacedTile> all = placed();
        bool also = false;
        for (const std::size_t i : which) {
            move(seen(all.at(i)));
            if (also) hold(ui::key_left_shift);
            click(seen(all.at(i)));
            if (also) hold(ui::key_left_shift, false);
            also = true;
        }
        wait();
    }
};

TEST(TileHand, TurnsTheTilesThatItHoldsByATypedAngle)
{
    HandRig rig;
    ASSERT_EQ(rig.placed().size(), 3u);
    const std::size_t before = rig.steps();
    rig.take({0, 2});
    EXPECT_EQ(rig.steps(), before); // a click moves nothing
    rig.key({'R'});
    rig.type("30");
    rig.frames();
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.editor.active_tool().name(), "Tiles");
    ASSERT_EQ(rig.tiles().strokes.size(), 2u);
    const TileStroke& turned = *rig.tiles().strokes[1];
    EXPECT_EQ(turned.brush, TileBrush::adjust);
    EXPECT_EQ(turned.turn_deg, 30);
    EXPECT_EQ(turned.samples.size(), 2u);
    EXPECT_EQ(rig.steps(), before + 1);
}

TEST(TileHand, ScalesWithTheMouseUntilAClickAndLeavesNoTraceOfWhatIsCancelled)
{
    HandRig rig;
    const double side = rig.placed()[1].height;
    rig.take({1});
    const glm::vec2 at = rig.seen(rig.placed()[1]);
    rig.move(at + glm::vec2(20, 0));
    rig.key({'S'});
    rig.move(at + glm::vec2(40, 0));
    rig.wait();
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.tiles().strokes.size(), 1u);
    EXPECT_NEAR(rig.placed()[1].height, side, 1e-9);
    rig.move(at + glm::vec2(20, 0));
    rig.key({'S'});
    rig.move(at + glm::vec2(40, 0));
    rig.click(at + glm::vec2(40, 0));
    rig.wait();
    ASSERT_EQ(rig.tiles().strokes.size(), 2u);
    EXPECT_NEAR(rig.tiles().strokes[1]->factor, 2, 0.2);
}

TEST(TileHand, DragsTilesOverTheSurfaceAndHoldsThemStill)
{
    HandRig rig;
    rig.take({0, 1});
    const glm::vec2 from = rig.seen(rig.placed()[1]);
    rig.draw({from, from + glm::vec2(0, -20), from + glm::vec2(0, -60)});
    rig.wait();
    ASSERT_EQ(rig.tiles().strokes.size(), 2u);
    EXPECT_EQ(rig.tiles().strokes[1]->brush, TileBrush::grab);
    EXPECT_EQ(rig.tiles().strokes[1]->samples.size(), 3u);
    const std::vector<PlacedTile> now = rig.placed();
    ASSERT_EQ(now.size(), 3u);
    EXPECT_NEAR(rig.seen(now.back()).y, from.y - 60, 4); // what moved comes last
    rig.key({ui::key_delete});                           // it is still held
    rig.wait();
    EXPECT_EQ(rig.placed().size(), 1u);
    EXPECT_EQ(rig.editor.session.document().objects.size(), 2u);
    EXPECT_EQ(rig.tiles().strokes.back()->factor, 0);
}

TEST(TileHand, TakesAllTilesOfOneKindWithControlOrTheKeyOfTheSameType)
{
    HandRig rig;
    AddBox bar;
    bar.shape = {.size = {0.2, 0.1, 0.04}, .segments = {1, 1, 1}};
    ASSERT_TRUE(rig.editor.session.run(bar));
    TileStroke more = *rig.tiles().strokes[0];
    for (TileSample& each : more.samples) each.at.p.z = 0.35;
    more.seed = 7;
    ASSERT_TRUE(rig.editor.session.run(PaintTiles{2, 1, more, {{3, 1}}}));
    rig.editor.session.selected = 2;
    rig.wait();
    const EvaluatedObject& layer = *rig.editor.session.evaluated().objects.at(2);
    ASSERT_EQ(layer.parts.size(), 2u);
    const std::size_t first = layer.parts[0].tiles->tiles->size(),
                      all = first + layer.parts[1].tiles->tiles->size();
    const glm::vec2 at = rig.seen(rig.placed().front()); // of the first part
    for (const bool by_key : {false, true}) {
        rig.move(at);
        if (!by_key) rig.hold(ui::key_left_control);
        rig.click(at);
        if (!by_key) rig.hold(ui::key_left_control, false);
        if (by_key) rig.key({.key = 'G', .shift = true});
        rig.wait();
        rig.key({ui::key_delete});
        rig.wait();
        ASSERT_FALSE(rig.placed().empty());
        EXPECT_EQ(rig.placed().size(), all - first);
        EXPECT_EQ(rig.tiles().strokes.back()->samples.size(), first);
        rig.editor.session.undo();
        rig.wait();
    }
}

TEST(TileHand, SaysThatNothingIsSelectedBeforeAKeyCanMoveIt)
{
    HandRig rig;
    rig.key({'R'});
    EXPECT_EQ(rig.editor.active_tool().name(), "Tiles");
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(TilesTool, JoinsTheLastStrokeByAClickWithShift)
{
    HandRig rig;
    rig.tool().choose_brush(TileBrush::scatter);
    const glm::vec2 c = rig.layout().view.center();
    rig.move(c + glm::vec2(-50, 30));
    rig.wait();
    rig.draw({c + glm::vec2(-50, 30), c + glm::vec2(-40, 30)});
    rig.wait();
    rig.hold(ui::key_left_shift);
    rig.move(c + glm::vec2(40, 30));
    rig.click(c + glm::vec2(40, 30));
    rig.hold(ui::key_left_shift, false);
    rig.wait();
    ASSERT_EQ(rig.tiles().strokes.size(), 3u);
    const std::vector<TileSample>& samples = rig.tiles().strokes[2]->samples;
    EXPECT_GE(samples.size(), 4u);
    EXPECT_LT(samples.front().at.p.x, samples.back().at.p.x - 0.3);
}

TEST(HeightsInHand, AreThoseOfALayerWhoseHeightIsProposed)
{
    HandRig rig;
    EXPECT_EQ(heights_in_hand(rig.editor.session), 0);
    rig.editor.session.propose(SetTiles{{2}, {.scale = 1.1}});
    EXPECT_EQ(heights_in_hand(rig.editor.session), 0);
    rig.editor.session.propose(SetTiles{{2}, {.height = 2}});
    EXPECT_EQ(heights_in_hand(rig.editor.session), 2);
    rig.editor.session.commit();
    EXPECT_EQ(heights_in_hand(rig.editor.session), 0);
}

TEST(LimitColors, GoFromGreyToRedAndStayThere)
{
    const auto hue = [](double share) {
        const glm::vec3 c = limit_color(share);
        return c.r - c.b;
    };
    EXPECT_LT(std::abs(hue(0)), 0.05);
    EXPECT_EQ(limit_color(0), limit_color(0.5));
    EXPECT_GT(hue(0.8), 0.4);
    EXPECT_EQ(limit_color(1), limit_color(7));
    EXPECT_LT(limit_color(1).g, 0.1f);
}

} // namespace
} // namespace trivar
