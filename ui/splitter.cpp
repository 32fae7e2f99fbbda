// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/splitter.h"

#include "ui/input.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {

Splitter splitter(Frame& frame, const char* name, const Rect& line)
{
    constexpr float patience_s = 0.08f; // a mouse that only passes changes nothing
    const Theme& theme = frame.theme;
    const bool upright = line.height() > line.width();
    const float reach = theme.px(3);
    const Rect grip = upright
                          ? Rect{{line.lo.x - reach, line.lo.y}, {line.hi.x + reach, line.hi.y}}
                          : Rect{{line.lo.x, line.lo.y - reach}, {line.hi.x, line.hi.y + reach}};
    ImGui::SetNextWindowPos({grip.lo.x, grip.lo.y});
    ImGui::SetNextWindowSize({grip.width(), grip.height()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(3);
    ImGui::SetCursorScreenPos({grip.lo.x, grip.lo.y});
    ImGui::InvisibleButton("grip", {grip.width(), grip.height()});
    Splitter result;
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) result.restored = true;
    if (active && !result.restored) hands().may_hold_on();
    if (active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0) && !result.restored) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        result.dragged = true;
        result.at = upright ? mouse.x : mouse.y;
    }
    const bool waited = GImGui->HoveredIdTimer >= patience_s;
    if (hovered && !active && !waited) frame.again_in(patience_s);
    if (active || (hovered && waited)) {
        ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        paint_box(line, theme.color.focus);
    }
    ImGui::End();
    return result;
}

} // namespace trivar::ui
