// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

// Two clicks in one place with so many seconds between the presses, and so many frames.
struct Clicks {
    double apart_s = 0.2, doubt_s = 0;
    int frames_between = 1;
    float moved_px = 0;
    double asked_s = 0.3;

    int doubles() const
    {
        HeadlessFrames screen{{320, 120}};
        int count = 0;
        const DrawFrame body = [&](Frame& frame) {
            frame.look.double_click_s = asked_s;
            count += ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ? 1 : 0;
        };
        screen.frames(2, body);
        for (int i = 0; i < 2; ++i) {
            Event down = press(Button::left, true, 5 + i * apart_s);
            down.doubt_s = i * doubt_s;
            screen.input().push(move_to({60 + static_cast<float>(i) * moved_px, 32}));
            screen.input().push(down);
            screen.input().push(press(Button::left, false, 5 + i * apart_s));
            screen.frames(frames_between, body);
        }
        screen.frames(4, body);
        return count;
    }
};

TEST(DoubleClick, IsOneHoweverLongTheFramesTook)
{
    EXPECT_EQ((Clicks{.frames_between = 1}.doubles()), 1);
    EXPECT_EQ((Clicks{.frames_between = 60}.doubles()), 1); // a second of the frames' clock
}

TEST(DoubleClick, IsNoneWhereThePressesWereTooFarApart)
{
    EXPECT_EQ((Clicks{.apart_s = 0.4}.doubles()), 0);
    EXPECT_EQ((Clicks{.moved_px = 20}.doubles()), 0);
}

TEST(DoubleClick, IsAsSlowAsAPersonAskedFor)
{
    EXPECT_EQ((Clicks{.apart_s = 0.5, .asked_s = 0.8}.doubles()), 1);
    EXPECT_EQ((Clicks{.apart_s = 0.25, .asked_s = 0.2}.doubles()), 0);
}

TEST(DoubleClick, IsOneWhereTheSecondPressMayHaveBeenMadeInTime)
{
    EXPECT_EQ((Clicks{.apart_s = 0.5, .doubt_s = 0.3}.doubles()), 1);
}

TEST(Keys, AreHeardOfByNobodyAfterTheyWereSwallowed)
{
    HeadlessFrames screen{{320, 120}};
    int before = 0, after = 0;
    const DrawFrame body = [&](Frame&) {
        before += struck({key_backspace}) ? 1 : 0;
        swallow_keys();
        after += struck({key_backspace}) ? 1 : 0;
    };
    for (int i = 0; i < 2; ++i) {
        screen.input().push(press_key(key_backspace));
        screen.input().push(press_key(key_backspace, false));
        screen.frames(4, body);
    }
    EXPECT_EQ(before, 2);
    EXPECT_EQ(after, 0);
}

TEST(Keys, RepeatWhileTheyAreHeldWhereThatIsWanted)
{
    HeadlessFrames screen{{320, 120}};
    int once = 0, again = 0;
    const DrawFrame body = [&](Frame&) {
        once += struck({key_right}) ? 1 : 0;
        again += struck({key_right}, true) ? 1 : 0;
    };
    screen.input().push(press_key(key_right));
    screen.frames(60, body);
    EXPECT_EQ(once, 1);
    EXPECT_GT(again, 5);
}

TEST(Input, SeesWhereADragEndedBeforeItEnds)
{
    HeadlessFrames screen{{320, 120}};
    float last_held = 0;
    const DrawFrame body = [&](Frame&) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) last_held = ImGui::GetIO().MousePos.x;
    };
    screen.frames(2, body);
    for (const Event& each : {move_to({60, 32}), press(Button::left), move_to({80, 32}),
                              move_to({100, 32}), press(Button::left, false)})
        screen.input().push(each);
    screen.frames(4, body);
    EXPECT_EQ(last_held, 100);
}

// A picture with a button beside it, on which the mouse rests.
struct BesideAButton {
    HeadlessFrames screen{{320, 120}};
    int picture = 0, button = 0; // presses
    std::vector<float> held_at;  // where the mouse was in each frame in which the picture was held
    bool wait = false;

    DrawFrame body()
    {
        return [this](Frame&) {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({320, 120});
            ImGui::Begin("all", nullptr, ImGuiWindowFlags_NoDecoration);
            lower_area("picture", {{0, 0}, {200, 120}}, ImGuiButtonFlags_MouseButtonLeft);
            const bool held = ImGui::IsItemActive();
            picture += held && ImGui::IsMouseClicked(ImGuiMouseButton_Left) ? 1 : 0;
            if (held) held_at.push_back(ImGui::GetIO().MousePos.x);
            ImGui::SetCursorScreenPos({220, 20});
            ImGui::InvisibleButton("button", {80, 80});
            button += ImGui::IsItemActivated() ? 1 : 0;
            if (wait) hands().hold_back(true);
            ImGui::End();
        };
    }
    void all_at_once(const std::vector<Event>& events)
    {
        for (const Event& each : events) screen.input().push(each);
        screen.frames(6, body());
    }
    BesideAButton() { all_at_once({move_to({260, 60})}); }
};

TEST(Input, GivesAPressToWhatWasUnderTheMouseHoweverLateTheFrame)
{
    BesideAButton all;
    all.all_at_once({move_to({60, 32}), press(Button::left), move_to({80, 32}), move_to({90, 32}),
                     press(Button::left, false), move_to({260, 60}), press(Button::left),
                     press(Button::left, false)});
    all.screen.frames(4, all.body());
    EXPECT_EQ(all.picture, 1);
    EXPECT_EQ(all.button, 1);
    ASSERT_FALSE(all.held_at.empty());
    EXPECT_EQ(all.held_at.front(), 60);
    EXPECT_EQ(all.held_at.back(), 90);
}

TEST(Input, HoldsPressesBackTillTheyHaveAnObject)
{
    BesideAButton all;
    all.wait = true;
    all.all_at_once({move_to({60, 32})});
    all.all_at_once({press(Button::left), press(Button::left, false)});
    EXPECT_EQ(all.picture, 0);
    EXPECT_FALSE(all.screen.input().pending()) << "an idle window waits for it";
    all.screen.input().push(press(Button::middle));
    all.screen.frames(2, all.body());
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Middle)) << "each in its turn";
    all.wait = false;
    all.screen.frames(6, all.body());
    EXPECT_EQ(all.picture, 1);
}

TEST(Input, LetsTheViewBeTurnedWhileItHoldsPressesBack)
{
    BesideAButton all;
    all.wait = true;
    all.screen.frames(1, all.body());
    for (const Event& each : {press_key(key_left_shift), press(Button::middle), press_key('1')})
        all.screen.input().push(each);
    all.screen.frames(4, all.body());
    EXPECT_TRUE(ImGui::IsMouseDown(ImGuiMouseButton_Middle));
    EXPECT_TRUE(ImGui::GetIO().KeyShift);
    EXPECT_FALSE(ImGui::GetIO().KeysDown['1']);
}

TEST(Input, HoldsNothingBackFromEsc)
{
    BesideAButton all;
    all.wait = true;
    all.screen.frames(1, all.body());
    int escaped = 0;
    all.screen.input().push(press_key('1'));
    all.screen.input().push(press_key(key_escape));
    all.screen.frames(4, [&](Frame& frame) {
        escaped += struck({key_escape}) ? 1 : 0;
        all.body()(frame);
    });
    EXPECT_EQ(escaped, 1);
}

} // namespace
} // namespace trivar::ui
