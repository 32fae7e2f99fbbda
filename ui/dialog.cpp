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

float draw_dialog_head(const Theme& theme, const Rect& dialog, const char* title)
{
    const float rule = dialog.lo.y + theme.px(56), end = rule + theme.size.hairline;
    paint_text(theme.font.title, {dialog.lo + glm::vec2(theme.px(24), 0), {dialog.hi.x, rule}},
               theme.color.text, title);
    paint_box({{dialog.lo.x, rule}, {dialog.hi.x, end}}, theme.color.line_soft);
    return end;
}

void end_dialog()
{
    ImGui::EndPopup();
}

namespace {

// The button that has the keyboard: kept while the dialog is open.
int move_focus(const Question& question)
{
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImHashStr("focused button");
    const int count = static_cast<int>(question.answers.size());
    int focused = ImGui::IsWindowAppearing() ? question.safe : storage->GetInt(id, question.safe);
    const bool back =
        ImGui::IsKeyPressed(key_left) || (ImGui::IsKeyPressed(key_tab) && ImGui::GetIO().KeyShift);
    const bool on = ImGui::IsKeyPressed(key_right) ||
                    (ImGui::IsKeyPressed(key_tab) && !ImGui::GetIO().KeyShift);
    focused = (focused + (on ? 1 : 0) + (back ? count - 1 : 0)) % count;
    storage->SetInt(id, focused);
    return focused;
}

} // namespace

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
    const int focused = move_focus(question);
    const float skip = theme.px(8);
    float apart = rect.lo.x + pad, x = rect.hi.x - pad + skip;
    for (const Question::Answer& answer : question.answers)
        if (!answer.apart) x -= button_width(theme, answer.words) + skip;
    std::optional<int> result;
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
        const Question::Answer& answer = question.answers[i];
        float& at = answer.apart ? apart : x;
        const float wide = button_width(theme, answer.words), top = rect.hi.y - pad - theme.px(32);
        ImGui::SetCursorScreenPos({at, top});
        if (button(theme, answer.words, answer.kind)) result = static_cast<int>(i);
        if (static_cast<int>(i) == focused)
            paint_rim(rect_at({at, top}, {wide, theme.px(32)}).grown(theme.px(2)),
                      theme.color.focus, theme.size.rounding + theme.px(2), 1.5f * theme.scale);
        at += wide + skip;
    }
    if (ImGui::IsKeyPressed(key_escape, false)) result = -1;
    if (ImGui::IsKeyPressed(key_enter, false) || ImGui::IsKeyPressed(key_keypad_enter, false) ||
        ImGui::IsKeyPressed(key_space, false))
        result = focused;
    if (result) ImGui::CloseCurrentPopup();
    end_dialog();
    return result;
}

} // namespace trivar::ui
