// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/dialogs/plan_dialog.h"

#include "core/base/rejected.h"
#include "ui/dialog.h"
#include "ui/keys.h"
#include "ui/sentence.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace trivar {

PlanAnswer draw_plan_dialog(const ui::Theme& theme, const PlanDialog& dialog)
{
    const ui::Palette& c = theme.color;
    const float line = theme.px(20), foot = theme.px(60), pad = theme.px(24), skip = theme.px(12);
    const float fields = std::round(theme.px(188.0f / 6) * static_cast<float>(dialog.rows));
    constexpr float lines = 3.8f; // of the paragraph
    const ui::Rect r = ui::begin_dialog(
        theme, dialog.title,
        {theme.px(600), theme.px(56) + skip + fields + skip + lines * line + foot});
    const bool typing = ImGui::IsAnyItemActive(); // these keys end that first
    const bool escape = !typing && ImGui::IsKeyPressed(ui::key_escape, false);
    const bool enter = !typing && (ImGui::IsKeyPressed(ui::key_enter, false) ||
                                   ImGui::IsKeyPressed(ui::key_keypad_enter, false));
    const float y0 = ui::draw_dialog_head(theme, r, dialog.title) + skip, y1 = r.hi.y - foot;
    const auto told = [&] {
        try {
            return std::pair(dialog.come_to(), true);
        } catch (const Rejected& refused) {
            return std::pair(ui::sentence(refused.what()), false);
        }
    };
    const auto paragraph = [&](const std::string& text) {
        return ui::wrapped(theme.font.body, text, r.width() - 2 * pad);
    };
    // In a small window the fields get the lines that the paragraph does not need, and roll.
    const float kept = static_cast<float>(paragraph(told().first).size()) * line;
    const float shown = std::min(fields, y1 - skip - kept - y0);
    ImGui::SetCursorScreenPos({r.lo.x + skip, y0});
    // The fields end where the buttons do.
    const float past = theme.px(ui::key_gutter) - pad;
    ImGui::BeginChild("plan", {r.width() - skip + past, shown}, false,
                      shown < fields ? 0 : ImGuiWindowFlags_NoScrollbar);
    dialog.fields();
    ImGui::EndChild();

    const auto [words, sense] = told(); // as the fields are now
    float y = y0 + shown + skip;
    for (const std::string& each : paragraph(words)) {
        ui::paint_text(theme.font.body, {{r.lo.x + pad, y}, {r.hi.x - pad, y + line}},
                       sense ? c.text_2 : c.bad, each);
        y += line;
    }

    ui::paint_box({{r.lo.x, y1}, {r.hi.x, y1 + theme.size.hairline}}, c.line_soft);
    const glm::vec2 size(theme.px(96), theme.px(32));
    const float row = std::round(y1 + (foot - size.y) / 2);
    PlanAnswer answer = PlanAnswer::none;
    ImGui::SetCursorScreenPos({r.hi.x - pad - 2 * size.x - theme.px(8), row});
    if (ui::button(theme, "Cancel", ui::ButtonKind::plain, size) || escape)
        answer = PlanAnswer::cancelled;
    ImGui::SetCursorScreenPos({r.hi.x - pad - size.x, row});
    ImGui::BeginDisabled(!sense);
    if ((ui::button(theme, dialog.begin(), ui::ButtonKind::primary, size) || enter) && sense)
        answer = PlanAnswer::begun;
    ImGui::EndDisabled();
    if (answer != PlanAnswer::none) ImGui::CloseCurrentPopup();
    ui::end_dialog();
    return answer;
}

bool draw_path_row(const ui::Theme& theme, const std::string& label, std::string& path,
                   const std::string& none, const std::string& help)
{
    const std::string words = "Browse...";
    const float all = ui::label_row(theme, label, false, help).width;
    const float wide = ui::button_width(theme, words), gap = theme.px(8);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ui::text_field(theme, label, path, none, all - wide - gap);
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({at.x + all - wide, at.y});
    const bool pressed = ui::button(theme, words, ui::ButtonKind::plain, {wide, theme.size.row});
    ImGui::SetCursorScreenPos(next);
    return pressed;
}

void draw_frames_row(const ui::Theme& theme, const Time& time, int& first, int& last, int* step)
{
    const float all = ui::label_row(theme, "Frames", false,
                                    step ? "The first frame, the last, and every how many."
                                         : "From the first to the last.")
                          .width;
    const int fields = step ? 3 : 2;
    const float gap = theme.px(8), width = std::floor((all - static_cast<float>(fields - 1) * gap) /
                                                      static_cast<float>(fields));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ui::NumberStyle frames{.lo = static_cast<double>(time.first_frame),
                                 .hi = static_cast<double>(time.last_frame)};
    const auto field = [&](int index, const char* id, int& value, ui::NumberStyle style,
                           const char* axis) {
        style.axis = axis;
        ImGui::SetCursorScreenPos({at.x + static_cast<float>(index) * (width + gap), at.y});
        ui::integer_field(theme, id, value, style, width);
    };
    field(0, "first", first, frames, "from");
    field(1, "last", last, frames, "to");
    if (step) field(2, "step", *step, {.lo = 1, .hi = 1000}, "every");
}

} // namespace trivar
