// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/option_bar.h"

#include "ui/headless.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <set>

namespace trivar::ui {
namespace {

// A bar of four settings; which of them were drawn in the last frame, and where.
struct Bar {
    float room = 0;
    HeadlessFrames screen{{900, 300}};
    std::vector<glm::vec2> drawn = std::vector<glm::vec2>(4);

    void frames()
    {
        screen.frames(4, [this](Frame& frame) {
            drawn.assign(4, glm::vec2(-1));
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({900, 40});
            ImGui::Begin("bar", nullptr, ImGuiWindowFlags_NoDecoration);
            ImGui::SetCursorScreenPos({0, 8});
            std::vector<Option> options;
            for (std::size_t i = 0; i < 4; ++i)
                options.push_back({"Setting", 100, [this, i](float width) {
                                       const ImVec2 at = ImGui::GetCursorScreenPos();
                                       drawn[i] = {at.x, at.y};
                                       ImGui::Dummy({width, 24});
                                   }});
            option_bar(frame.theme, options, room);
            ImGui::End();
        });
    }
};

TEST(OptionBar, DrawsAllWhereThereIsRoom)
{
    Bar bar;
    bar.room = 880;
    bar.frames();
    for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(bar.drawn[i].x, 0);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(bar.drawn[i].x, bar.drawn[i - 1].x + 100);
}

TEST(OptionBar, MovesWholeSettingsIntoTheMenuAtItsEnd)
{
    Bar bar;
    bar.room = 420;
    bar.frames();
    std::size_t fit = 0;
    while (fit < 4 && bar.drawn[fit].x >= 0) ++fit;
    ASSERT_GT(fit, 0u);
    ASSERT_LT(fit, 4u);
    EXPECT_LE(bar.drawn[fit - 1].x + 100, bar.room);
    const float more = bar.drawn[fit - 1].x + 100 + 16 + 12; // the button behind the last
    bar.screen.input().push(move_to({more, 20}));
    bar.screen.input().push(press(Button::left));
    bar.screen.input().push(press(Button::left, false));
    bar.frames();
    bar.frames();
    for (std::size_t i = fit; i < 4; ++i) EXPECT_GT(bar.drawn[i].y, 40) << "below the bar";
}

} // namespace
} // namespace trivar::ui
