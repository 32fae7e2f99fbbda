// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <optional>

namespace trivar::ui {
namespace {

// Two rows, of which the first differs from its default.
struct Rows {
    HeadlessFrames screen{{400, 300}};
    std::array<int, 2> resets{};

    void strike_over(float y)
    {
        const auto draw = [&](Frame& frame) {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({400, 300});
            ImGui::Begin("panel");
            for (const int i : {0, 1}) {
                ImGui::SetCursorScreenPos({0, 40.0f * static_cast<float>(i + 1)});
                const Row row = label_row(frame.theme, i == 0 ? "Width" : "Height", i == 0);
                resets[static_cast<std::size_t>(i)] += row.reset;
            }
            ImGui::End();
        };
        screen.input().push(move_to({200, y}));
        screen.frames(2, draw);
        screen.input().push(press_key(key_backspace));
        screen.input().push(press_key(key_backspace, false));
        screen.frames(3, draw);
    }
};

TEST(Row, GoesBackToItsDefaultByBackspaceOverIt)
{
    Rows rows;
    rows.strike_over(50);
    EXPECT_EQ(rows.resets[0], 1);
    rows.strike_over(90); // that one is as it was at first
    EXPECT_EQ(rows.resets[1], 0);
    rows.strike_over(200);
    EXPECT_EQ(rows.resets[0], 1);
}

// A number between two rows, which need not apply.
struct Greyed {
    HeadlessFrames screen{{400, 300}};
    double value = 1;
    bool applies = false;
    float below = 0; // where the row after it is
    std::optional<Tip> tip;

    void frames(int count)
    {
        screen.frames(count, [&](Frame& frame) {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({400, 300});
            ImGui::Begin("panel");
            rows_if(frame.theme, applies, "Wave is 0.", [&] {
                const Row row = label_row(frame.theme, "Phase", true, "turns of the wave");
                if (row.reset) value = 0;
                number_field(frame.theme, "phase", value, {}, row.width);
            });
            below = ImGui::GetCursorScreenPos().y;
            ImGui::End();
            tip = tooltips().shown();
        });
    }
    void drag()
    {
        screen.input().push(move_to({200, 40}));
        screen.input().push(press(Button::left));
        frames(2);
        screen.input().push(move_to({260, 40}));
        frames(2);
        screen.input().push(press(Button::left, false));
        frames(2);
    }
};

TEST(GreyedRows, KeepTheirPlaceAndTakeNothing)
{
    Greyed rows;
    rows.frames(2);
    const float below = rows.below;
    rows.drag();
    rows.screen.input().push(press_key(key_backspace));
    rows.frames(2);
    EXPECT_EQ(rows.value, 1);
    rows.screen.input().push(press_key(key_backspace, false));
    rows.applies = true;
    rows.frames(2);
    EXPECT_EQ(rows.below, below);
    rows.drag();
    EXPECT_NE(rows.value, 1);
}

TEST(GreyedRows, SayWhyTheyDoNotApply)
{
    Greyed rows;
    rows.screen.input().push(move_to({40, 40}));
    rows.frames(90);
    ASSERT_TRUE(rows.tip);
    EXPECT_EQ(rows.tip->sentence, "Wave is 0. Turns of the wave.");
}

} // namespace
} // namespace trivar::ui
