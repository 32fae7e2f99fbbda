// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/boxes.h"
#include "tests/editor/scenes.h"

#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar {
namespace {

using testing::Boxes, testing::Rig;

// Into the uppermost number field of the inspector, at the left: the position along X.
void type_x(testing::Rig& rig, const std::string& text)
{
    const ui::Rect in = rig.layout().inspector;
    const ui::Theme& theme = rig.screen.theme();
    const float x = in.lo.x + theme.size.padding + theme.size.label + 20;
    for (float y = in.lo.y; y < in.hi.y; y += 4) {
        rig.move({x, y});
        if (ImGui::GetMouseCursor() != ImGuiMouseCursor_ResizeEW) continue;
        rig.click({x, y + 8});
        rig.frames(4);
        rig.type(text);
        rig.key({ui::key_enter});
        return rig.wait();
    }
    ADD_FAILURE() << "there is no field";
}
// A third one, at (0, 2, 0).
void third(Boxes& rig)
{
    AddBox box;
    box.transform.translation = {0, 2, 0};
    ASSERT_TRUE(rig.editor.session.run(box));
}

TEST(Several, AllGetTheNumberThatIsTypedAsOneStep)
{
    Boxes rig;
    third(rig);
    rig.editor.session.selected.set({1, 2, 3});
    rig.wait();
    const std::size_t before = rig.steps();
    const double y2 = rig.of(2).translation.y;
    type_x(rig, "4");
    EXPECT_EQ(rig.steps(), before + 1);
    for (const Id id : {1, 2, 3}) EXPECT_EQ(rig.of(id).translation.x, 4) << id;
    EXPECT_EQ(rig.of(2).translation.y, y2);
    rig.editor.session.undo();
    EXPECT_NE(rig.of(1).translation.x, rig.of(2).translation.x);
}

TEST(Several, WhatIsLockedStaysWhereItIs)
{
    Boxes rig;
    third(rig);
    ASSERT_TRUE(rig.editor.session.run(Lock{{2}}));
    rig.editor.session.selected.set({1, 2, 3});
    rig.wait();
    const Transform before = rig.of(2);
    type_x(rig, "4");
    EXPECT_EQ(rig.of(1).translation.x, 4);
    EXPECT_EQ(rig.of(2), before);
}

TEST(Several, KeepWhatTheirTravelsDifferInWhenOneNumberOfAllIsTyped)
{
    Rig rig({1024, 900});
    SceneFile scene = testing::typical_scene();
    scene.run(AddBox{});
    scene.run(testing::placed(6, 1));
    scene.run(SetTravel{{6}, {.speed = 0.5, .start_frame = 30}});
    rig.editor.session.replace_scene(std::move(scene));
    rig.editor.session.selected.set({2, 6});
    rig.wait();
    const std::size_t before = rig.steps();
    type_x(rig, "0.4"); // the speed: nothing here has a position
    EXPECT_EQ(rig.steps(), before + 1);
    const auto travel = [&](Id id) { return object(rig.editor.session.document(), id).travel; };
    EXPECT_EQ(travel(2).speed, 0.4);
    EXPECT_EQ(travel(6).speed, 0.4);
    EXPECT_EQ(travel(2).ends, Ends::loop);
    EXPECT_EQ(travel(2).start_frame, 1);
    EXPECT_EQ(travel(6).start_frame, 30);
}

TEST(ViewportMenu, IsOfWhatIsUnderTheMouseAndNotOfAGestureThatTheButtonEnded)
{
    Boxes rig;
    rig.editor.session.selected = 0;
    const auto right_click = [&](glm::vec2 at) {
        rig.screen.input().push(ui::move_to(at));
        rig.frames(2);
        rig.screen.input().push(ui::press(ui::Button::right));
        rig.frames(2);
        rig.screen.input().push(ui::press(ui::Button::right, false));
        rig.frames(3);
    };
    const glm::vec2 box = rig.seen_at(rig.of(2).translation);
    right_click(box);
    EXPECT_EQ(rig.editor.session.selected, 2);
    EXPECT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId));
    rig.key({ui::key_escape});
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId));
    rig.key({'G'});
    ASSERT_TRUE(rig.editor.active_tool().busy());
    right_click(box + glm::vec2(20, 0));
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId));
}

} // namespace
} // namespace trivar
