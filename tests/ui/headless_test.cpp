// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"

#include "ui/keys.h"
#include "ui/widgets.h"

#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

// One window that fills the picture, with a single number field at (20, 20), 100 wide.
struct FieldRig {
    HeadlessFrames screen{{320, 120}};
    double value = 2;
    int changes = 0, cancels = 0;
    NumberStyle style{.lo = 0, .hi = 10, .bar_hi = 10};

    DrawFrame body()
    {
        return [this](Frame& frame) {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({320, 120});
            ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
            ImGui::SetCursorScreenPos({20, 20});
            const Edit edit = number_field(frame.theme, "value", value, style, 100);
            changes += edit == Edit::changed;
            cancels += edit == Edit::cancelled;
            ImGui::End();
        };
    }
    void type(const std::string& text, int end = key_enter)
    {
        screen.frames(2, body());
        screen.input().push(move_to({60, 32}));
        screen.input().push(press(Button::left));
        screen.input().push(press(Button::left, false)); // both before a frame could see either
        screen.frames(6, body());
        for (const char c : text) screen.input().push(type_text(static_cast<unsigned>(c)));
        screen.input().push(press_key(end));
        screen.input().push(press_key(end, false));
        screen.frames(6, body());
    }
    void drag(float from, float to, int steps)
    {
        screen.frames(2, body()); // a press finds only windows that were drawn before
        screen.input().push(move_to({from, 32}));
        screen.input().push(press(Button::left));
        screen.frames(3, body());
        for (int i = 1; i <= steps; ++i) {
            screen.input().push(move_to(
                {from + (to - from) * static_cast<float>(i) / static_cast<float>(steps), 32}));
            screen.frames(1, body());
        }
    }
};

TEST(NumberField, ADragChangesOnePercentOfTheRangeEachFourPixels)
{
    FieldRig rig;
    rig.drag(60, 100, 10);
    EXPECT_NEAR(rig.value, 2 + 10 * 0.01 * 40 / 4, 1e-9);
    EXPECT_EQ(rig.changes, 10);
}

TEST(NumberField, EscapeDuringADragRestoresTheValue)
{
    FieldRig rig;
    rig.drag(60, 100, 5);
    rig.screen.input().push(press_key(key_escape));
    rig.screen.frames(2, rig.body());
    EXPECT_EQ(rig.value, 2);
    EXPECT_EQ(rig.cancels, 1);
}

TEST(NumberField, ADragStopsAtTheEndsOfTheRange)
{
    FieldRig rig;
    rig.drag(60, 5000, 4);
    EXPECT_EQ(rig.value, 10);
    rig.drag(60, -9000, 4);
    EXPECT_EQ(rig.value, 0);
}

TEST(NumberField, AClickOpensItForTyping)
{
    FieldRig rig;
    rig.type("7.25");
    EXPECT_EQ(rig.value, 7.25);
    EXPECT_EQ(rig.changes, 1);
}

TEST(NumberField, TakesExpressionsUnitsAndChangesOfWhatIsThere)
{
    FieldRig rig;
    rig.type("2 * (1 + 0.5)");
    EXPECT_EQ(rig.value, 3);
    rig.type("+=0.5");
    EXPECT_EQ(rig.value, 3.5);
    rig.style.unit = "m";
    rig.type("50 cm");
    EXPECT_EQ(rig.value, 0.5);
}

TEST(NumberField, CtrlDragsInRoundSteps)
{
    FieldRig rig;
    rig.value = 1.37;
    rig.style = {.lo = -100, .hi = 100};
    rig.screen.input().push(press_key(key_left_control));
    rig.drag(60, 97, 5);
    EXPECT_EQ(rig.value, 1.6);
}

TEST(NumberField, TabGoesToTheNextAndFromTheLastToTheFirst)
{
    FieldRig rig;
    rig.type("3", key_tab);
    EXPECT_EQ(rig.value, 3);
    for (const char c : std::string("4"))
        rig.screen.input().push(type_text(static_cast<unsigned>(c)));
    rig.screen.input().push(press_key(key_enter));
    rig.screen.frames(6, rig.body());
    EXPECT_EQ(rig.value, 4) << "the only one is its own next";
}

TEST(NumberField, WhatCannotBeReadChangesNothing)
{
    FieldRig rig;
    for (const char* text : {"7 +", "7 deg", "seven", "1/0"}) rig.type(text);
    EXPECT_EQ(rig.value, 2);
    EXPECT_EQ(rig.changes, 0);
}

TEST(Frames, AMouseAtRestOnOneThingOverAnotherIsIdle)
{
    HeadlessFrames screen{{320, 120}};
    const DrawFrame body = [](Frame&) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({320, 120});
        ImGui::Begin("both");
        ImGui::SetCursorScreenPos({20, 20});
        ImGui::InvisibleButton("below", {200, 80});
        ImGui::SetItemAllowOverlap();
        ImGui::SetCursorScreenPos({40, 30});
        ImGui::InvisibleButton("above", {60, 60});
        ImGui::End();
    };
    screen.input().push(move_to({60, 50}));
    EXPECT_LT(screen.settle(body), 50);
}

TEST(Frames, AnIdleWindowDrawsNothing)
{
    FieldRig rig;
    EXPECT_LE(rig.screen.settle(rig.body()), 5) << "a few frames settle, then none are due";
    rig.screen.input().push(move_to({60, 32}));
    EXPECT_LE(rig.screen.settle(rig.body()), 12) << "the same after the mouse moved";
}

TEST(Frames, AClickBetweenTwoFramesIsSeen)
{
    HeadlessFrames screen({200, 100});
    int clicks = 0;
    const DrawFrame body = [&](Frame& frame) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({200, 100});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::SetCursorScreenPos({10, 10});
        clicks += button(frame.theme, "Press", ButtonKind::primary);
        ImGui::End();
    };
    screen.frames(2, body);
    for (int i = 0; i < 3; ++i) {
        screen.input().push(move_to({30, 20}));
        screen.input().push(press(Button::left));
        screen.input().push(press(Button::left, false));
    }
    screen.settle(body);
    EXPECT_EQ(clicks, 3);
}

TEST(Frames, ThePictureShowsWhatWasDrawn)
{
    HeadlessFrames screen({64, 64});
    const Color accent = screen.theme().color.accent;
    screen.frames(2, [&](Frame&) {
        ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {64, 32}, accent);
    });
    const Image image = screen.picture();
    EXPECT_EQ(image.rgba[0], accent & 255u) << "the first row is the top one";
    EXPECT_EQ(image.rgba[4 * 64 * 63], 0);
}

TEST(WrappedIndex, CutsAWordThatIsWiderThanALineAndLosesNothing)
{
    HeadlessFrames screen({64, 64});
    screen.frames(1, [&](Frame& frame) {
        const ImFont* font = frame.theme.font.body;
        const std::string path = "/a/very/long/path/that/has/no/blank/größe/scene.trivar";
        std::string all;
        for (const std::string& line : wrapped(font, "not at " + path, 90)) {
            EXPECT_LE(text_width(font, line), 90);
            all += line + (line == "not at" ? " " : "");
        }
        EXPECT_EQ(all, "not at " + path);
        EXPECT_EQ(wrapped(font, "é", 1).size(), 1u) << "a line holds at least one character";
    });
}

TEST(Theme, ANumberIsShownWithThreeSignificantDigits)
{
    EXPECT_EQ(short_number(0.42), "0.42");
    EXPECT_EQ(short_number(0.123456), "0.123");
    EXPECT_EQ(short_number(12.3456), "12.3");
    EXPECT_EQ(short_number(1234.5), "1,234");
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(1e-9), "0.000000001");
    EXPECT_EQ(short_number(2.5e7), "25,000,000");
    EXPECT_EQ(short_number(-3), "-3.00");
}

} // namespace
} // namespace trivar::ui
