// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "tests/editor/tools/incise/incise_rig.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::InciseRig;

TEST(InciseTool, CutsWhereTheHandDrawsInOneStep)
{
    InciseRig rig;
    const std::size_t before = rig.steps(), whole = rig.vertices();
    rig.cut();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.incising());
    EXPECT_EQ(rig.outcome().refusal, "");
    EXPECT_GT(rig.vertices(), whole);
    for (const SurfacePoint& each : rig.one().cut.stroke) {
        EXPECT_NEAR(glm::length(each.p), 1, 0.01);
        EXPECT_GT(glm::dot(each.p, each.normal), 0.98);
        EXPECT_LT(each.p.y, 0);
    }
    EXPECT_EQ(rig.editor.session.incision, (ChosenIncision{1, 1}));
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.incising());
    EXPECT_EQ(rig.vertices(), whole);
}

TEST(InciseTool, ShowsWhatLettingGoMakes)
{
    InciseRig rig;
    rig.drag({{-90, 10}, {0, -20}, {90, 10}}, false);
    const Document shown = rig.editor.session.document();
    const Ref<Mesh> mesh = rig.editor.session.evaluated().objects.at(1)->parts.front().rest;
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames(3);
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), digest(shown));
    EXPECT_EQ(*rig.editor.session.evaluated().objects.at(1)->parts.front().rest.ref(), *mesh);
}

TEST(InciseTool, LeavesNoTraceWhenItIsCancelled)
{
    InciseRig rig;
    const std::size_t before = rig.steps(), whole = rig.vertices();
    rig.drag({{-90, 10}, {90, 10}}, false);
    EXPECT_GT(rig.vertices(), whole);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.vertices(), whole);
}

TEST(InciseTool, ChoosesAndLeavesIncisionsByClicks)
{
    InciseRig rig;
    rig.cut();
    rig.click(rig.layout().view.center() + glm::vec2(0, 120));
    rig.wait();
    EXPECT_EQ(rig.editor.session.incision, ChosenIncision{});
    const std::size_t before = rig.steps();
    rig.click(rig.seen_at(rig.one().cut.stroke.front().p));
    rig.wait();
    EXPECT_EQ(rig.editor.session.incision, (ChosenIncision{1, 1}));
    EXPECT_EQ(rig.steps(), before);
    rig.key({ui::key_delete});
    rig.wait();
    EXPECT_FALSE(rig.incising());
    EXPECT_TRUE(rig.editor.session.document().objects.contains(1));
}

TEST(InciseTool, FindsTheModelAtRestUnderATurnedAndScaledObject)
{
    Transform transform;
    transform.rotation_deg = {20, 30, 40};
    transform.scale = {1.4, 0.8, 1.1};
    InciseRig rig(transform);
    rig.cut();
    ASSERT_TRUE(rig.incising());
    for (const SurfacePoint& each : rig.one().cut.stroke) EXPECT_NEAR(glm::length(each.p), 1, 0.01);
    // and what is seen of it lies under the hand
    const glm::dvec3 end = transform.matrix() * glm::dvec4(rig.one().cut.stroke.back().p, 1);
    EXPECT_LT(glm::distance(rig.seen_at(end), rig.layout().view.center() + glm::vec2(90, 10)), 3);
}

TEST(InciseTool, JoinsTheEndOfAnotherIncision)
{
    InciseRig rig;
    rig.cut();
    const glm::vec2 end = rig.seen_at(rig.one().cut.stroke.back().p) - rig.layout().view.center();
    rig.drag({{60, 130}, end + glm::vec2(5, 6)});
    ASSERT_EQ(rig.incising()->cuts.size(), 2u);
    EXPECT_EQ(rig.one(1).cut.stroke.back().p, rig.one(0).cut.stroke.back().p);
    EXPECT_EQ(rig.outcome(1).refusal, "");
}

TEST(InciseTool, DrawsOverAnOpenWoundFromSideToSide)
{
    InciseRig rig;
    rig.cut();
    rig.drag({{0, -100}, {0, 100}});
    ASSERT_EQ(rig.incising()->cuts.size(), 2u);
    for (const SurfacePoint& each : rig.one(1).cut.stroke)
        EXPECT_NEAR(glm::length(each.p), 1, 0.01);
    EXPECT_EQ(rig.outcome(1).refusal, "");
}

TEST(IncisionHandles, WriteTheNumbersThatTheyShowInOneStepEach)
{
    InciseRig rig;
    rig.cut();
    const NamedIncision first = rig.one();
    const std::string whole = digest(rig.editor.session.committed());

    std::size_t before = rig.steps();
    rig.pull_along("right", -4);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(rig.one().opening.share, 1);
    EXPECT_GT(rig.one().opening.share, 0);
    EXPECT_EQ(rig.one().cut, first.cut);
    EXPECT_NE(
        rig.handle("right").words.find(fmt::format("{:.3g} %", 100 * rig.one().opening.share)),
        std::string::npos);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), whole);

    before = rig.steps();
    rig.pull_along("left", 30);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(rig.one().opening.share, 1);
    EXPECT_GT(rig.one().cut.width, first.cut.width);
    rig.editor.session.undo();
    rig.wait();

    before = rig.steps();
    rig.pull_along("depth", 20);
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_GT(rig.one().cut.depth, first.cut.depth);
    EXPECT_EQ(rig.one().cut.stroke, first.cut.stroke);
    rig.editor.session.undo();
    rig.wait();

    before = rig.steps();
    rig.pull("zip", {-80, 0});
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(rig.one().opening.to, 0.75);
    EXPECT_GT(rig.one().opening.to, 0.25);
    EXPECT_EQ(rig.one().cut, first.cut);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), whole);
}

TEST(IncisionHandles, MoveAnEndAndAllOfIt)
{
    InciseRig rig;
    rig.cut();
    const NamedIncision first = rig.one();
    rig.pull("end", {30, 40});
    EXPECT_EQ(rig.one().cut.stroke.front().p, first.cut.stroke.front().p);
    EXPECT_GT(glm::distance(rig.one().cut.stroke.back().p, first.cut.stroke.back().p), 0.2);
    for (const SurfacePoint& each : rig.one().cut.stroke) EXPECT_NEAR(glm::length(each.p), 1, 0.01);
    EXPECT_EQ(rig.outcome().refusal, "");
    const double length = length_of(rig.one().cut.stroke);
    rig.pull("place", {0, 60});
    EXPECT_LT(rig.one().cut.stroke.front().p.z, first.cut.stroke.front().p.z - 0.2);
    EXPECT_NEAR(length_of(rig.one().cut.stroke), length, 0.05 * length);
    EXPECT_EQ(rig.outcome().refusal, "");
}

TEST(IncisionHandles, ShowWhatLettingGoMakes)
{
    InciseRig rig;
    rig.cut();
    rig.pull_along("depth", 20, false);
    const std::string shown = digest(rig.editor.session.document());
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames(3);
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), shown);
}

} // namespace
} // namespace trivar
