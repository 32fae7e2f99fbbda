// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/view.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/split/split_field.h"
#include "editor/tools/split/split.h"
#include "editor/tools/split/split_handles.h"
#include "tests/editor/rig.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar {
namespace {

// A ball that a pillar parts, selected, seen from the front and above.
struct HoldRig : testing::Rig {
    HoldRig() : Rig({900, 640})
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 1}}));
        EXPECT_TRUE(editor.session.run(AddCylinder{.shape = {.radius = 0.2, .height = 3}}));
        EXPECT_TRUE(editor.session.run(
            Split{{1}, {.obstacles = {{.object = 2, .clearance = 0.05}}, .opening = {1, 0, 0}}}));
        editor.session.selected = 1;
        editor.session.view.camera.eye = {0, -6, 3};
        editor.session.view.camera.target = {0, 0, 0};
        key({'K'});
        wait();
    }
    const EvaluatedObject& ball() const { return *editor.session.evaluated().objects.at(1); }
    const Object& own() const { return object(editor.session.committed(), 1); }
    Handle handle(std::string_view kind, int side = 0) const
    {
        std::vector<Handle> all = opening_handles(editor.session, 1);
        std::ranges::move(cut_handles(editor.session, 1), std::back_inserter(all));
        for (const Handle& each : all)
            if (each.key == HandleKey{kind, {0, side}}) return each;
        ADD_FAILURE() << "there is no such handle";
        return {};
    }
    // Pulls a handle so far in the world.
    void pull(const Handle& handle, const glm::dvec3& by, bool let_go = true)
    {
        const glm::vec2 at = layout().view.lo + glm::vec2(handle.p_px);
        move(at);
        draw({at, at + seen_at(handle.p_world + by) - seen_at(handle.p_world)}, let_go);
        wait();
    }
    void cut(double gap)
    {
        ASSERT_TRUE(editor.session.run(ClearSplit{{1}}));
        ASSERT_TRUE(editor.session.run(CutThrough{{1}, {.cuts = {{.gap = gap}}}}));
        dynamic_cast<SplitTool&>(editor.active_tool()).set_at(editor.session, SplitAt::plane);
        wait();
    }
};

TEST(SplitHandles, AWallSetsTheClearanceInOneStep)
{
    HoldRig rig;
    const std::size_t before = rig.steps();
    const Handle wall = rig.handle("clearance", 1);
    EXPECT_EQ(wall.words, "Clearance 0.05 m");
    EXPECT_GT(wall.p_world.x, 0.25);
    rig.pull(wall, {0.1, 0, 0});
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.own().splitting->obstacles[0].clearance, 0.15, 0.01);
    EXPECT_NEAR(rig.handle("clearance", 1).p_world.x, wall.p_world.x + 0.1, 0.03);
    rig.pull(rig.handle("clearance", -1), {5, 0, 0}); // no nearer than the obstacle
    EXPECT_EQ(rig.own().splitting->obstacles[0].clearance, 0);
}

TEST(SplitHandles, AnArrowSetsTheReachAndTheLeastIsAutomatic)
{
    HoldRig rig;
    const Handle arrow = rig.handle("reach", -1);
    const std::string words = arrow.words;
    EXPECT_TRUE(words.ends_with(", the least")) << words;
    const double least = rig.ball().split_field->openings[0].reach[0];
    rig.pull(arrow, {-0.3, 0, 0});
    EXPECT_NEAR(rig.own().splitting->obstacles[0].reach, least + 0.3, 0.01);
    EXPECT_NEAR(rig.ball().split_field->openings[0].reach[0], least + 0.3, 0.01);
    EXPECT_EQ(rig.handle("reach", -1).words.find("least"), std::string::npos);
    rig.pull(rig.handle("reach", 1), {-2, 0, 0});
    EXPECT_EQ(rig.own().splitting->obstacles[0].reach, 0);
    EXPECT_EQ(rig.handle("reach", -1).words, words);
}

TEST(SplitHandles, TheRingMovesTheObstacleLevelAndLive)
{
    HoldRig rig;
    const Handle ring = rig.handle("place");
    rig.pull(ring, {0, 0.4, 0}, false);
    EXPECT_NEAR(rig.ball().split_field->frame.origin.y, 0.4, 0.01); // before it is let go
    EXPECT_EQ(object(rig.editor.session.committed(), 2).transform.translation, glm::dvec3(0));
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    const glm::dvec3 there = object(rig.editor.session.committed(), 2).transform.translation;
    EXPECT_NEAR(there.y, 0.4, 0.01);
    EXPECT_NEAR(there.z, 0, 1e-9);
    ASSERT_TRUE(rig.editor.session.run(Lock{{2}}));
    rig.wait();
    const std::vector<Handle> left = opening_handles(rig.editor.session, 1);
    EXPECT_FALSE(left.empty());
    for (const Handle& each : left) EXPECT_NE(each.key.kind, "place");
}

TEST(SplitHandles, EscapeAndALockLeaveNoTrace)
{
    HoldRig rig;
    const std::size_t before = rig.steps();
    const std::string then = digest(rig.editor.session.committed());
    const Handle wall = rig.handle("clearance", 1);
    rig.pull(wall, {0.1, 0, 0}, false);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(digest(rig.editor.session.document()), then);
    ASSERT_TRUE(rig.editor.session.run(Lock{{1}}));
    rig.wait();
    EXPECT_TRUE(opening_handles(rig.editor.session, 1).empty());
    rig.pull(wall, {0.1, 0, 0});
    EXPECT_EQ(rig.own().splitting->obstacles[0].clearance, 0.05);
}

TEST(SplitHandles, OfACutMoveItAndOpenItsGap)
{
    HoldRig rig;
    rig.cut(0.2);
    const std::size_t before = rig.steps();
    rig.pull(rig.handle("level"), {0, 0, 0.3});
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.own().cutting->cuts[0].point.z, 0.3, 0.01);
    rig.pull(rig.handle("gap", 1), {0, 0, 0.2}); // each part by that
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_NEAR(rig.own().cutting->cuts[0].gap, 0.6, 0.02);
    rig.pull(rig.handle("gap", -1), {0, 0, 3});
    EXPECT_EQ(rig.own().cutting->cuts[0].gap, 0);
}

TEST(SplitHandles, TakeATypedNumberInPlaceOfTheWayOfTheHand)
{
    HoldRig rig;
    rig.cut(0.2);
    const std::size_t before = rig.steps();
    rig.pull(rig.handle("gap", 1), {0, 0, 0.1}, false);
    rig.type("0.123456");
    rig.wait();
    EXPECT_EQ(object(rig.editor.session.document(), 1).cutting->cuts[0].gap, 0.123456); // shown
    EXPECT_EQ(rig.own().cutting->cuts[0].gap, 0.2);
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(rig.own().cutting->cuts[0].gap, 0.123456);
}

TEST(SplitHandles, OfACutThatIsAnimatedSetAKey)
{
    HoldRig rig;
    rig.cut(0.2);
    ASSERT_TRUE(rig.editor.session.run(SetTime{{.first_frame = 1, .last_frame = 24}}));
    ASSERT_TRUE(rig.editor.session.run(
        Animate{{{1, {{"cutting.cuts.0.gap", {{1, 0.2, Tween::linear}, {24, 0.8}}}}}}}));
    rig.editor.session.show_frame(24);
    rig.wait();
    rig.pull(rig.handle("gap", 1), {0, 0, 0.1});
    EXPECT_NEAR(document_at(rig.editor.session.committed(), 24).objects.at(1)->cutting->cuts[0].gap,
                1.0, 0.02);
    EXPECT_NEAR(document_at(rig.editor.session.committed(), 1).objects.at(1)->cutting->cuts[0].gap,
                0.2, 1e-9);
}

} // namespace
} // namespace trivar
