// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <gtest/gtest.h>
#include <imgui.h>

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

} // namespace
} // namespace trivar::ui
