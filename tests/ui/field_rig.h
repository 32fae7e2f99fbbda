// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/headless.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar::testing {

// A FieldRig draws one field at (20, 20) of a window, and hands do something with it.
class FieldRig {
public:
    int chosen = -1, changes = 0, cancels = 0;

    virtual ~FieldRig() = default;
    FieldRig(const FieldRig&) = delete;
    FieldRig& operator=(const FieldRig&) = delete;

    ui::DrawFrame body()
    {
        return [this](ui::Frame& frame) {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({static_cast<float>(size_.x), static_cast<float>(size_.y)});
            ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
            ImGui::SetCursorScreenPos({20, 20});
            const ui::Edit edit = draw(frame.theme);
            changes += edit == ui::Edit::changed;
            cancels += edit == ui::Edit::cancelled;
            ImGui::End();
        };
    }
    void drag(glm::vec2 from, glm::vec2 to, bool let_go = true)
    {
        screen.input().push(ui::move_to(from));
        screen.frames(2, body());
        screen.input().push(ui::press(ui::Button::left));
        screen.frames(2, body());
        for (int i = 1; i <= 4; ++i) {
            screen.input().push(ui::move_to(glm::mix(from, to, static_cast<float>(i) / 4)));
            screen.frames(1, body());
        }
        if (let_go) screen.input().push(ui::press(ui::Button::left, false));
        screen.frames(3, body());
    }

    ui::HeadlessFrames screen;

protected:
    explicit FieldRig(glm::ivec2 size_px) : screen(size_px), size_(size_px) {}
    virtual ui::Edit draw(const ui::Theme& theme) = 0;

private:
    glm::ivec2 size_;
};

} // namespace trivar::testing
