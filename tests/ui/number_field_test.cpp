// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed: into number fields, and as the name of a file that is there already.
#include "tests/support/fixtures.h"
#include "ui/file_dialog.h"
#include "ui/headless.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <array>
#include <fstream>
#include <gtest/gtest.h>
#include <imgui.h>
#include <span>

namespace trivar::ui {
namespace {

struct Typist {
    HeadlessFrames screen{{720, 560}};
    DrawFrame body;

    void type(const std::string& text)
    {
        for (const char c : text) screen.input().push(type_text(static_cast<unsigned char>(c)));
        screen.frames(3, body);
    }
    void key(int key, bool ctrl = false)
    {
        if (ctrl) screen.input().push(press_key(key_left_control));
        screen.input().push(press_key(key));
        screen.input().push(press_key(key, false));
        if (ctrl) screen.input().push(press_key(key_left_control, false));
        screen.frames(8, body);
    }
    void click(glm::vec2 at)
    {
        screen.input().push(move_to(at));
        screen.input().push(press(Button::left));
        screen.input().push(press(Button::left, false));
        screen.frames(6, body);
    }
};

// Numbers from 0 to 10, one under the other.
DrawFrame fields(std::span<double> values)
{
    return [values](Frame& frame) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({360, 180});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        for (std::size_t i = 0; i < values.size(); ++i) {
            ImGui::SetCursorScreenPos({20, 20 + 40 * static_cast<float>(i)});
            number_field(frame.theme, "number " + std::to_string(i), values[i], {.lo = 0, .hi = 10},
                         120);
        }
        ImGui::End();
    };
}

// A number from 0 to 10 that is being typed; its value at the end.
double typed(double value, const std::vector<std::string>& tries)
{
    Typist hand;
    hand.body = fields({&value, 1});
    hand.screen.frames(2, hand.body);
    hand.click({60, 30});
    for (const std::string& text : tries) {
        hand.type(text);
        hand.key(key_enter);
    }
    hand.click({300, 150});
    return value;
}

TEST(NumberField, TakesWhatIsTypedWithinItsLimits)
{
    EXPECT_EQ(typed(2, {"7.5"}), 7.5);
    EXPECT_EQ(typed(2, {"+=1"}), 3);
}

TEST(NumberField, NeitherReplacesNorDropsWhatIsBeyondThemButIsTypedOn)
{
    EXPECT_EQ(typed(2, {"12"}), 2);
    EXPECT_EQ(typed(2, {"-1"}), 2);
    EXPECT_EQ(typed(2, {"12", "9"}), 9); // the 12 stood there, chosen
}

TEST(NumberField, SaysThatWhatIsLeftWasNotTaken)
{
    Typist hand;
    double value = 2;
    hand.body = fields({&value, 1});
    hand.screen.frames(2, hand.body);
    const auto resting = hand.screen.picture().rgba;
    hand.click({60, 30});
    hand.type("12");
    hand.click({300, 150}); // away
    EXPECT_EQ(value, 2);
    EXPECT_NE(hand.screen.picture().rgba, resting) << "it stands under the field";
    hand.click({300, 150});
    EXPECT_EQ(hand.screen.picture().rgba, resting);
    hand.click({60, 30});
    hand.type("12");
    hand.key(key_escape); // on purpose
    hand.click({300, 150});
    EXPECT_EQ(hand.screen.picture().rgba, resting);
}

TEST(NumberField, ChangesNothingByWhatCannotBeRead)
{
    EXPECT_EQ(typed(2, {"seven"}), 2);
    EXPECT_EQ(typed(2, {"seven", "7"}), 7);
}

TEST(NumberField, KeepsEveryDigitOfAValueThatIsLookedAt)
{
    EXPECT_EQ(typed(1.3399999999999999, {""}), 1.3399999999999999);
}

TEST(NumberField, GivesItsValueToOthersByTheRightButton)
{
    Typist hand;
    std::array<double, 2> values{2.5, 7};
    hand.body = fields(values);
    const auto choose = [&](glm::vec2 field, int entry) {
        hand.screen.input().push(move_to(field));
        hand.screen.input().push(press(Button::right));
        hand.screen.input().push(press(Button::right, false));
        hand.screen.frames(6, hand.body);
        const float row = ImGui::GetTextLineHeightWithSpacing();
        hand.click(field + glm::vec2(20, row * (0.8f + static_cast<float>(entry))));
    };
    hand.screen.frames(2, hand.body);
    choose({60, 30}, 0);
    choose({60, 70}, 1);
    EXPECT_EQ(values[1], 2.5);
    EXPECT_EQ(values[0], 2.5);
    ImGui::SetClipboardText("12"); // beyond its limits: the entry is off
    choose({60, 70}, 1);
    EXPECT_EQ(values[1], 2.5);
}

TEST(FileDialog, EnterAloneReplacesNoFile)
{
    const testing::TemporaryFolder folder;
    std::ofstream(folder.file("a.txt")) << "x";
    Typist hand;
    FileDialog dialog;
    std::optional<std::string> chosen;
    hand.body = [&](Frame& frame) {
        if (const auto path = dialog.draw(frame.theme)) chosen = path;
    };
    const FileRequest request{
        .title = "Save", .action = "Save", .extensions = {".txt"}, .saving = true, .name = "a"};
    dialog.open(request, folder.path());
    hand.screen.frames(4, hand.body);
    for (int i = 0; i < 3; ++i) hand.key(key_enter);
    EXPECT_TRUE(dialog.is_open());
    EXPECT_FALSE(chosen);
    hand.key(key_enter, true);
    EXPECT_FALSE(dialog.is_open());
    EXPECT_EQ(chosen.value_or(""), folder.file("a.txt"));
}

// One number that clicks hold, and a hand on it.
struct Holder : Typist {
    double value = 5;
    Holder()
    {
        body = [this](Frame& frame) {
            frame.look.click_holds = true;
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({360, 180});
            ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
            ImGui::SetCursorScreenPos({20, 20});
            NumberStyle now = style;
            now.stop = stop;
            number_field(frame.theme, "number", value, now, 160);
            ImGui::End();
        };
        screen.frames(2, body);
    }
    double stop = 1e300;
    NumberStyle style{.lo = 0, .hi = 10, .bar_hi = 10};
    void move(glm::vec2 at)
    {
        screen.input().push(move_to(at));
        screen.frames(2, body);
    }
};

TEST(HeldByAClick, ANumberFollowsTheHandTillASecondClick)
{
    Holder hand;
    hand.click({60, 30});
    hand.move({80, 30});
    const double while_held = hand.value;
    EXPECT_GT(while_held, 5);
    hand.move({-1e6f, 0}); // out of the window and back
    hand.move({100, 60});
    EXPECT_GT(hand.value, while_held);
    hand.click({100, 60});
    const double at_end = hand.value;
    hand.move({60, 60});
    EXPECT_EQ(hand.value, at_end);
    EXPECT_FALSE(ImGui::IsAnyItemActive());
}

TEST(HeldByAClick, ADragWithTheButtonHeldEndsWhereItIsLetGo)
{
    Holder hand;
    hand.move({60, 30});
    hand.screen.input().push(press(Button::left));
    hand.move({90, 30});
    hand.screen.input().push(press(Button::left, false));
    hand.move({120, 30});
    EXPECT_GT(hand.value, 5);
    EXPECT_FALSE(ImGui::IsAnyItemActive());
}

TEST(ADragOfAFactor, GoesByShareOfOneAndOfWhatIsLarger)
{
    for (const double start : {0.0, 1.0, 4.0}) {
        Holder hand;
        hand.style = {.lo = 0, .hi = 100, .usual = 1};
        hand.value = start;
        hand.move({20, 30});
        hand.screen.input().push(press(Button::left));
        hand.move({60, 30});
        EXPECT_NEAR(hand.value - start, 0.2 * std::max(1.0, start), 0.05 * std::max(1.0, start));
        hand.screen.input().push(press(Button::left, false));
        hand.move({60, 30});
    }
}

TEST(ADragWithAStop, HaltsThereForAWhileAndGoesOnIfItIsPulledFurther)
{
    Holder hand;
    hand.stop = 6;
    hand.move({20, 30});
    hand.screen.input().push(press(Button::left));
    hand.move({40, 30}); // a fortieth per pixel
    EXPECT_GT(hand.value, 5);
    EXPECT_LT(hand.value, 6);
    hand.move({70, 30});
    EXPECT_EQ(hand.value, 6);
    hand.move({100, 30});
    EXPECT_EQ(hand.value, 6);
    hand.move({160, 30});
    EXPECT_GT(hand.value, 6);
    EXPECT_LT(hand.value, 8);
    hand.move({40, 30});
    EXPECT_LT(hand.value, 6);
    hand.screen.input().push(press(Button::left, false));
    hand.move({40, 30});
}

TEST(HeldByAClick, EscapeRestoresAndADoubleClickTypes)
{
    Holder hand;
    hand.click({60, 30});
    hand.move({80, 30});
    hand.key(key_escape);
    hand.move({120, 30});
    EXPECT_EQ(hand.value, 5);
    hand.move({60, 30});
    for (const bool down : {true, false, true, false})
        hand.screen.input().push(press(Button::left, down));
    hand.screen.frames(8, hand.body);
    hand.type("7.5");
    hand.key(key_enter);
    EXPECT_EQ(hand.value, 7.5);
}

} // namespace
} // namespace trivar::ui
