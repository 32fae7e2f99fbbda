// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/cut.h"
#include "core/split/cut_sheet.h"
#include "editor/tools/split/drawn_cut.h"
#include "editor/tools/split/split.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::Rig;

// A ball before the camera, selected, and the tool with that choice in its bar.
struct CutRig : Rig {
    explicit CutRig(SplitAt at)
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 1}}));
        editor.session.selected = 1;
        editor.session.view.camera.eye = {0, -5, 0};
        editor.session.view.camera.target = {0, 0, 0};
        key({'K'});
        wait();
        dynamic_cast<SplitTool&>(editor.active_tool()).set_at(editor.session, at);
        wait();
    }
    void drag(const std::vector<glm::vec2>& way, bool let_go = true)
    {
        const glm::vec2 c = layout().view.center();
        std::vector<glm::vec2> path;
        for (const glm::vec2& p : way) path.push_back(c + p);
        move(path.front());
        wait();
        draw(path, let_go);
        wait();
    }
    const std::optional<Cutting>& cutting() const
    {
        return object(editor.session.committed(), 1).cutting;
    }
    std::size_t parts() const { return editor.session.evaluated().objects.at(1)->parts.size(); }
};

TEST(CutByPlane, CutsAlongALineThroughTheEye)
{
    CutRig rig(SplitAt::plane);
    EXPECT_EQ(rig.editor.active_tool().name(), "Split");
    const std::size_t before = rig.steps();
    rig.drag({{-200, -30}, {200, -30}});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.cutting());
    ASSERT_EQ(rig.cutting()->cuts.size(), 1u);
    const PlainCut& cut = rig.cutting()->cuts[0];
    EXPECT_TRUE(cut.stroke.empty());
    EXPECT_GT(cut.normal.z, 0.9); // from left to right: above is up
    EXPECT_NEAR(glm::dot(cut.normal, glm::dvec3(0, -5, 0) - cut.point), 0, 1e-3);
    EXPECT_GT(cut.point.z, 0.05);
    EXPECT_EQ(rig.parts(), 2u);
    rig.drag({{10, -120}, {-10, 120}}); // across it
    EXPECT_EQ(rig.cutting()->cuts.size(), 2u);
    EXPECT_EQ(rig.parts(), 4u);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.cutting());
    EXPECT_EQ(rig.parts(), 1u);
}

TEST(CutByStroke, FollowsTheStroke)
{
    CutRig rig(SplitAt::stroke);
    rig.drag({{-200, 0}, {-100, -50}, {0, 0}, {100, 50}, {200, 0}});
    ASSERT_TRUE(rig.cutting());
    const PlainCut& cut = rig.cutting()->cuts.at(0);
    EXPECT_GT(cut.stroke.size(), 8u);
    EXPECT_NEAR(cut.eye, 5, 0.2);
    const auto [least, most] = std::ranges::minmax_element(cut.stroke, {}, &glm::dvec2::y);
    EXPECT_LT(least->y, -0.1);
    EXPECT_GT(most->y, 0.1);
    EXPECT_LT(most->x, least->x); // up first
    EXPECT_EQ(rig.parts(), 2u);
}

TEST(CutByStroke, RefusesAStrokeThatTurnsBackInASentence)
{
    CutRig rig(SplitAt::stroke);
    const std::size_t before = rig.steps();
    rig.drag({{-200, 0}, {100, -50}, {-50, 50}, {200, 0}});
    EXPECT_EQ(rig.steps(), before);
    EXPECT_FALSE(rig.cutting());
    EXPECT_EQ(rig.parts(), 1u);
}

TEST(CutByPlane, IsShownWhileItIsDrawnAndLeavesNoTraceWhenCancelled)
{
    CutRig rig(SplitAt::plane);
    const std::size_t before = rig.steps();
    rig.drag({{-200, 0}, {200, 0}}, false);
    EXPECT_EQ(rig.parts(), 2u);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.parts(), 1u);
}

TEST(CutByPlane, TakesAClickForASelection)
{
    CutRig rig(SplitAt::plane);
    EXPECT_TRUE(rig.editor.session.run(
        AddBox{.shape = {.size = {0.3, 0.3, 0.3}}, .transform = {.translation = {0, -2, 0}}}));
    rig.editor.session.selected = 1;
    rig.wait();
    const std::size_t before = rig.steps();
    rig.click(rig.layout().view.center());
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_FALSE(rig.cutting());
}

TEST(DrawnCut, IsSeenUnderTheStrokeOnAScaledAndTurnedObject)
{
    DrawnWay way;
    way.camera.eye = {3, -4, 2};
    Transform transform;
    transform.translation = {0.2, 0.1, 0};
    transform.rotation_deg = {20, 30, 40};
    transform.scale = {1, 2, 0.5};
    way.own_to_world = transform.matrix();
    for (int i = 0; i <= 60; ++i)
        way.points_px.emplace_back(440 + 7 * i, 360 + 60 * std::sin(i / 10.0));
    const std::optional<PlainCut> cut = cut_along_way(way);
    ASSERT_TRUE(cut);
    // Points on rays through the stroke are on the surface, at any depth
    const glm::dmat4 to_own = glm::inverse(way.own_to_world);
    const CutSheet sheet(*cut, to_own);
    for (int i = 5; i <= 55; i += 5) {
        const Ray ray = ray_through(way.camera, way.points_px[static_cast<std::size_t>(i)]);
        for (const double far : {4.0, 5.5, 7.0})
            EXPECT_NEAR(sheet.height(sheet.uvw(ray.origin + far * ray.direction)), 0, 0.02);
    }
}

TEST(DrawnCut, IsFlippedWithoutMoving)
{
    PlainCut cut{.point = {0, 0, 0.2}, .normal = {0, 0, 1}, .along = {1, 0, 0}, .eye = 3};
    cut.stroke = {{-1, 0}, {0.2, 0.3}, {1, 0.1}};
    const Cutting turned = flipped({.cuts = {cut}}, 0);
    const CutSheet one(cut, glm::dmat4(1)), other(turned.cuts[0], glm::dmat4(1));
    for (const glm::dvec3& p : {glm::dvec3(0.3, 0.2, 0.1), glm::dvec3(-0.5, 1, 0.6)})
        EXPECT_NEAR(one.height(one.uvw(p)), -other.height(other.uvw(p)), 1e-12);
}

} // namespace
} // namespace trivar
