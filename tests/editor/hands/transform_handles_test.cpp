// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/transform_gesture.h"
#include "tests/editor/boxes.h"

#include <imgui.h>

namespace trivar {
namespace {

using testing::Boxes;

// A drag on a handle, found by where it is drawn.
glm::vec2 handle_of(const Boxes& rig, MotionKind kind, GizmoHandle wanted)
{
    const auto stands = stands_of(rig.editor.session.document(), rig.editor.session.selected.ids());
    const Camera& camera = rig.editor.session.view.camera;
    const MotionFrame frame{pivot_of(stands, rig.editor.session.selected, Pivot::origin, {}),
                            glm::dmat3(1)};
    for (const HandleShape& shape : gizmo_shapes(kind, camera, frame, 1))
        if (shape.handle == wanted)
            return rig.layout().view.lo + (shape.area.empty() ? shape.line[10] : shape.area[0]);
    return {};
}

TEST(TransformByHandle, AnArrowMovesAlongItsAxisOnly)
{
    Boxes rig;
    rig.editor.choose_tool(1);
    rig.frames();
    const glm::vec2 arrow = handle_of(rig, MotionKind::move, {Grip::axis, 0});
    rig.draw({arrow, arrow + glm::vec2(60, 25)});
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_GT(rig.of(1).translation.x, -1.4);
    EXPECT_EQ(rig.of(1).translation.y, 0);
    EXPECT_EQ(rig.of(1).translation.z, 0);
}

TEST(TransformByHandle, AClickOnAHandleIsNoStepAndEscapeDuringADragNeither)
{
    Boxes rig;
    rig.editor.choose_tool(3);
    rig.frames();
    const glm::vec2 box = handle_of(rig, MotionKind::scale, {Grip::axis, 2}) + glm::vec2(2, 2);
    rig.click(box);
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_EQ(rig.editor.session.selected, 1);
    rig.draw({box, box - glm::vec2(0, 60)}, false);
    rig.wait();
    EXPECT_GT(rig.of(1).scale.z, 1.1);
    EXPECT_EQ(rig.of(1).scale.x, 1);
    rig.key({ui::key_escape});
    rig.let_go();
    EXPECT_EQ(rig.of(1).scale, glm::dvec3(1));
    EXPECT_EQ(rig.steps(), 2u);
}

TEST(TransformByHandle, ARingTurnsAboutItsAxisAndAClickBesideSelects)
{
    Boxes rig;
    rig.editor.choose_tool(2);
    rig.frames();
    const glm::vec2 ring = handle_of(rig, MotionKind::rotate, {Grip::ring, 1});
    rig.draw({ring, ring + glm::vec2(30, 40)});
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(rig.of(1).rotation_deg.x, 0);
    EXPECT_NE(rig.of(1).rotation_deg.y, 0);
    rig.click(rig.seen_at({1.5, -0.5, 0}));
    EXPECT_EQ(rig.editor.session.selected, 2);
    EXPECT_EQ(rig.steps(), 3u);
}

TEST(TransformByHandle, AClickHoldsItTillASecondOneWhereThatIsPreferred)
{
    Boxes rig;
    rig.editor.preferences.look.click_holds = true;
    rig.editor.choose_tool(1);
    rig.frames();
    const glm::vec2 arrow = handle_of(rig, MotionKind::move, {Grip::axis, 0});
    rig.click(arrow);
    rig.move(arrow + glm::vec2(60, 25));
    rig.wait();
    EXPECT_TRUE(rig.editor.active_tool().busy());
    EXPECT_EQ(rig.steps(), 2u);
    rig.click(arrow + glm::vec2(60, 25));
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    const Transform moved = rig.of(1);
    EXPECT_GT(moved.translation.x, -1.4);
    rig.click(handle_of(rig, MotionKind::move, {Grip::axis, 0}));
    rig.move(arrow + glm::vec2(-30, 0));
    rig.screen.input().push(ui::press(ui::Button::right)); // leaves no trace
    rig.screen.input().push(ui::press(ui::Button::right, false));
    rig.wait();
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_EQ(rig.of(1).translation, moved.translation);
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    EXPECT_EQ(rig.steps(), 3u);
}

TEST(Camera, IsTurnedBetweenTwoClicksWhereThatIsPreferred)
{
    Boxes rig;
    rig.editor.preferences.look.click_holds = true;
    rig.frames();
    const auto middle_click = [&] {
        rig.screen.input().push(ui::press(ui::Button::middle));
        rig.screen.input().push(ui::press(ui::Button::middle, false));
        rig.frames(4);
    };
    const auto eye = [&] { return rig.editor.session.view.camera.eye; };
    const glm::dvec3 before = eye();
    middle_click();
    rig.move(rig.away() + glm::vec2(50, 0));
    const glm::dvec3 turned = eye();
    EXPECT_NE(turned, before);
    middle_click();
    rig.move(rig.away());
    EXPECT_EQ(eye(), turned);
}

} // namespace
} // namespace trivar
