// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialog.h"

#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {

Rect begin_dialog(const Theme& theme, const char* name, glm::vec2 size, const DialogStyle& style)
{
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    size = glm::min(size, glm::vec2(window.x, window.y) - theme.px(32));
    glm::vec2 at = glm::round((glm::vec2(window.x, window.y) - size) / 2.0f);
    if (style.from_top >= 0) at.y = std::min(at.y, std::round(style.from_top));
    ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg] =
        ImGui::ColorConvertU32ToFloat4(faded(theme.color.scrim, style.scrim));
    GImGui->DimBgRatio = 1; // at once: a window that sleeps would stop in the middle of a fade
    if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(10));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::BeginPopupModal(name, nullptr,
                           ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(3);
    const Rect rect = rect_at(at, size);
    paint_card(theme, rect);
    return rect;
}

void end_dialog()
{
    ImGui::EndPopup();
}

std::optional<int> ask(const Theme& theme, const Question& question)
{
    const float pad = theme.px(24), line = theme.px(20), width = theme.px(440);
    const auto lines = wrapped(theme.font.body, question.text, width - 2 * pad);
    const float height =
        2 * pad + theme.px(36) + line * static_cast<float>(lines.size()) + theme.px(20 + 32);
    const Rect rect = begin_dialog(theme, "question", {width, height});
    float y = rect.lo.y + pad;
    paint_text(theme.font.title, {{rect.lo.x + pad, y}, {rect.hi.x, y + theme.px(24)}},
               theme.color.text, question.title);
    y += theme.px(36);
    for (const std::string& words : lines) {
        paint_text(theme.font.body, {{rect.lo.x + pad, y}, {rect.hi.x, y + line}},
                   theme.color.text_2, words);
        y += line;
    }
    float x = rect.hi.x - pad;
    for (const Question::Answer& answer : question.answers)
        x -= button_width(theme, answer.words) + theme.px(8);
    x += theme.px(8);
    std::optional<int> result;
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
        const Question::Answer& answer = question.answers[i];
        ImGui::SetCursorScreenPos({x, rect.hi.y - pad - theme.px(32)});
        if (button(theme, answer.words, answer.kind)) result = static_cast<int>(i);
        x += button_width(theme, answer.words) + theme.px(8);
    }
    if (ImGui::IsKeyPressed(key_escape, false)) result = -1;
    if (ImGui::IsKeyPressed(key_enter, false)) result = question.safe;
    if (result) ImGui::CloseCurrentPopup();
    end_dialog();
    return result;
}

} // namespace trivar::ui
