// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooltip.h"

#include "ui/headless.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

bool meet(const Rect& a, const Rect& b)
{
    return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

TEST(TooltipPlace, IsInsideTheWindowAndNotOnTheThing)
{
    const glm::vec2 window{1024, 700};
    for (const float scale : {1.0f, 2.0f})
        for (const glm::vec2 size : {glm::vec2(60, 34), glm::vec2(280, 120)})
            for (const glm::vec2 thing :
                 {glm::vec2(24, 24), glm::vec2(300, 24), glm::vec2(36, 200)})
                for (float x = 0; x + thing.x <= window.x; x += 60)
                    for (float y = 0; y + thing.y <= window.y; y += 60)
                        for (const Side side : {Side::below, Side::right, Side::left}) {
                            const Rect clear = rect_at({x, y}, thing);
                            const Rect words = rect_at(
                                tooltip_place(clear, clear.center(), size, window, side, scale),
                                size);
                            ASSERT_FALSE(meet(clear, words)) << x << ", " << y;
                            ASSERT_GE(words.lo.x, 0);
                            ASSERT_GE(words.lo.y, 0);
                            ASSERT_LE(words.hi.x, window.x);
                            ASSERT_LE(words.hi.y, window.y);
                        }
}

TEST(TooltipPlace, IsLeftOfAPanelAtTheRowWhereThereIsRoom)
{
    const Rect row = {{700, 200}, {1024, 228}};
    const glm::vec2 at = tooltip_place(row, {900, 214}, {260, 60}, {1024, 700}, Side::left, 1);
    EXPECT_LE(at.x + 260, 700);
    EXPECT_EQ(at.y, 200);
}

// Two buttons beside each other, each with a tooltip.
struct Buttons {
    HeadlessFrames screen{{400, 300}};
    static void draw(Frame&)
    {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 300});
        ImGui::Begin("panel");
        for (const float x : {50.0f, 100.0f}) {
            const std::string name = x == 50 ? "one" : "two";
            ImGui::SetCursorScreenPos({x, 50});
            ImGui::InvisibleButton(name.c_str(), {40, 40});
            tooltip({name, "K", "a sentence"});
        }
        ImGui::End();
    }
    void frames(int count) { screen.frames(count, draw); }
    void move(float x)
    {
        screen.input().push(move_to({x, 60}));
        frames(1);
    }
    std::string shown() const { return tooltips().shown() ? tooltips().shown()->name : ""; }
};
constexpr int half_second = 33, sixth_of_a_second = 12;

TEST(Tooltips, ComeWhenTheMouseRestsAndSoonerAfterAnother)
{
    Buttons buttons;
    buttons.move(60);
    buttons.frames(20);
    EXPECT_EQ(buttons.shown(), "");
    buttons.frames(half_second - 20);
    EXPECT_EQ(buttons.shown(), "one");
    buttons.move(110);
    EXPECT_EQ(buttons.shown(), "");
    buttons.frames(sixth_of_a_second);
    EXPECT_EQ(buttons.shown(), "two");
    buttons.move(300);
    EXPECT_EQ(buttons.shown(), "");
}

TEST(Tooltips, GoWithAPressAndStayAwayUntilTheMouseGoesElsewhere)
{
    Buttons buttons;
    buttons.move(60);
    buttons.frames(half_second);
    buttons.screen.input().push(press(Button::left));
    buttons.frames(2);
    EXPECT_EQ(buttons.shown(), "");
    buttons.screen.input().push(press(Button::left, false));
    buttons.frames(2 * half_second);
    EXPECT_EQ(buttons.shown(), "") << "it was pressed, so it is known";
    buttons.move(300);
    buttons.move(60);
    buttons.frames(half_second);
    EXPECT_EQ(buttons.shown(), "one");
}

TEST(Tooltips, AskForTheFrameInWhichTheyComeAndForNoOther)
{
    Buttons buttons;
    buttons.move(60);
    EXPECT_LT(buttons.screen.settle(Buttons::draw), 20);
    EXPECT_EQ(buttons.shown(), "one");
    EXPECT_LE(buttons.screen.settle(Buttons::draw), 3) << "it stays, and costs nothing";
}

} // namespace
} // namespace trivar::ui
