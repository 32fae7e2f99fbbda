// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/view.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/split/split_field.h"
#include "editor/tools/split/split.h"
#include "tests/editor/rig.h"

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
    SplitHoldPoint hold(SplitHoldKind kind, int side = 0) const
    {
        std::vector<SplitHoldPoint> all = split_holds(editor.session.document(), ball());
        // with the values of the frame
        if (const std::optional<Cutting>& cutting = object(editor.session.document(), 1).cutting) {
            const std::vector<SplitHoldPoint> cuts = cut_holds(*cutting, ball());
            all.insert(all.end(), cuts.begin(), cuts.end());
        }
        for (const SplitHoldPoint& point : all)
            if (point.hold == SplitHold{kind, 0, side}) return point;
        ADD_FAILURE() << "there is no such handle";
        return {};
    }
    glm::vec2 handle(const SplitHoldPoint& point) const
    {
        return layout().view.lo + glm::vec2(*trivar::seen_at(point, editor.session.view.camera, 1));
    }
    // Pulls a handle so many metres along its way.
    void pull(const SplitHoldPoint& point, double by, bool let_go = true)
    {
        const glm::vec2 at = handle(point);
        move(at);
        draw({at, at + seen_at(point.p_world + by * point.way) - seen_at(point.p_world)}, let_go);
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
    const SplitHoldPoint wall = rig.hold(SplitHoldKind::clearance, 1);
    EXPECT_EQ(wall.value, 0.05);
    EXPECT_GT(wall.p_world.x, 0.25);
    rig.pull(wall, 0.1);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.own().splitting->obstacles[0].clearance, 0.15, 0.01);
    EXPECT_NEAR(rig.hold(SplitHoldKind::clearance, 1).p_world.x, wall.p_world.x + 0.1, 0.03);
    rig.pull(rig.hold(SplitHoldKind::clearance, -1), -5); // no nearer than the obstacle
    EXPECT_EQ(rig.own().splitting->obstacles[0].clearance, 0);
}

TEST(SplitHandles, AnArrowSetsTheReachAndTheLeastIsAutomatic)
{
    HoldRig rig;
    const SplitHoldPoint arrow = rig.hold(SplitHoldKind::reach, -1);
    EXPECT_EQ(arrow.value, arrow.least);
    rig.pull(arrow, 0.3);
    EXPECT_NEAR(rig.own().splitting->obstacles[0].reach, arrow.least + 0.3, 0.01);
    EXPECT_NEAR(rig.ball().split_field->openings[0].reach[0], arrow.least + 0.3, 0.01);
    rig.pull(rig.hold(SplitHoldKind::reach, 1), -2);
    EXPECT_EQ(rig.own().splitting->obstacles[0].reach, 0);
    EXPECT_EQ(rig.hold(SplitHoldKind::reach, 1).value, arrow.least);
}

TEST(SplitHandles, TheRingMovesTheObstacleLevelAndLive)
{
    HoldRig rig;
    const SplitHoldPoint ring = rig.hold(SplitHoldKind::place);
    rig.pull(ring, 0.4, false);
    EXPECT_NEAR(rig.ball().split_field->frame.origin.y, 0.4, 0.01); // before it is let go
    EXPECT_EQ(object(rig.editor.session.committed(), 2).transform.translation, glm::dvec3(0));
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    const glm::dvec3 there = object(rig.editor.session.committed(), 2).transform.translation;
    EXPECT_NEAR(there.y, 0.4, 0.01);
    EXPECT_NEAR(there.z, 0, 1e-9);
    ASSERT_TRUE(rig.editor.session.run(Lock{{2}}));
    rig.wait();
    for (const SplitHoldPoint& each : split_holds(rig.editor.session.document(), rig.ball()))
        EXPECT_NE(each.hold.kind, SplitHoldKind::place);
}

TEST(SplitHandles, EscapeAndALockLeaveNoTrace)
{
    HoldRig rig;
    const std::size_t before = rig.steps();
    const std::string then = digest(rig.editor.session.committed());
    rig.pull(rig.hold(SplitHoldKind::clearance, 1), 0.1, false);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(digest(rig.editor.session.document()), then);
    ASSERT_TRUE(rig.editor.session.run(Lock{{1}}));
    rig.wait();
    rig.pull(rig.hold(SplitHoldKind::clearance, 1), 0.1);
    EXPECT_EQ(rig.own().splitting->obstacles[0].clearance, 0.05);
}

TEST(SplitHandles, OfACutMoveItAndOpenItsGap)
{
    HoldRig rig;
    rig.cut(0.2);
    const std::size_t before = rig.steps();
    rig.pull(rig.hold(SplitHoldKind::level), 0.3);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.own().cutting->cuts[0].point.z, 0.3, 0.01);
    rig.pull(rig.hold(SplitHoldKind::gap, 1), 0.2); // each part by that
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_NEAR(rig.own().cutting->cuts[0].gap, 0.6, 0.02);
    rig.pull(rig.hold(SplitHoldKind::gap, -1), -3);
    EXPECT_EQ(rig.own().cutting->cuts[0].gap, 0);
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
    rig.pull(rig.hold(SplitHoldKind::gap, 1), 0.1);
    EXPECT_NEAR(document_at(rig.editor.session.committed(), 24).objects.at(1)->cutting->cuts[0].gap,
                1.0, 0.02);
    EXPECT_NEAR(document_at(rig.editor.session.committed(), 1).objects.at(1)->cutting->cuts[0].gap,
                0.2, 1e-9);
}

} // namespace
} // namespace trivar
