// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {

void draw_tabs(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.tabs;
    begin_panel("tabs", r, c.panel);
    float x = r.lo.x + theme.px(8);
    const auto tab = [&](Editor::Tab which, const std::string& name) {
        const bool on = editor.tab == which;
        const float width = ui::text_width(theme.font.strong, name) + theme.px(20);
        const ui::Rect at = ui::rect_at({x, r.lo.y + theme.px(8)}, {width, theme.size.row});
        ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
        if (ImGui::InvisibleButton(name.c_str(), {width, at.height()})) editor.tab = which;
        if (on || ImGui::IsItemHovered())
            ui::paint_box(at, on ? c.field : c.row_hover, theme.size.rounding);
        ui::paint_text(on ? theme.font.strong : theme.font.body, at, on ? c.text : c.text_2, name,
                       ui::Align::center);
        x += width + theme.px(4);
    };
    tab(Editor::Tab::inspector, "Inspector");
    tab(Editor::Tab::history, "History");
    ImGui::End();
}

void draw_history(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const History& history = editor.session.scene().history();
    begin_panel("inspector", layout.inspector, c.panel, true);
    const float height = theme.size.row, width = layout.inspector.width();
    const std::size_t count = history.steps().size();
    if (count == 0) {
        ui::empty_state(theme, layout.inspector, ui::icon::history, "No steps yet",
                        "Steps appear here. Each can be returned to.");
        ImGui::End();
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    std::optional<std::size_t> go_to;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count) + 1, height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto step = static_cast<std::size_t>(i); // after so many steps
            ImGui::PushID(i);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const ui::Rect row = ui::rect_at({layout.inspector.lo.x, at.y}, {width, height});
            if (ImGui::InvisibleButton("step", {width, height})) go_to = step;
            const bool present = step == history.position(), undone = step > history.position();
            const ui::Rect band = {row.lo + glm::vec2(theme.px(4), 0),
                                   row.hi - glm::vec2(theme.px(4), 0)};
            if (present)
                ui::paint_box(band, c.row_selected, theme.size.rounding_small);
            else if (ImGui::IsItemHovered())
                ui::paint_box(band, c.row_hover, theme.size.rounding_small);
            const Document& before = step < 2 ? history.start() : history.steps()[step - 2].result;
            const std::string words =
                step == 0 ? "Empty scene" : title(history.steps()[step - 1].command, before);
            const ui::Rect text = {row.lo + glm::vec2(theme.px(12), 0),
                                   row.hi - glm::vec2(theme.px(12), 0)};
            ui::paint_text(theme.font.small, text, present ? c.text_2 : c.text_3,
                           std::to_string(step));
            ui::paint_text(present ? theme.font.strong : theme.font.body,
                           {text.lo + glm::vec2(theme.px(32), 0), text.hi},
                           undone ? c.text_3 : c.text,
                           ui::elided(theme.font.body, words, text.width() - theme.px(36)));
            ImGui::PopID();
        }
    ImGui::PopStyleVar();
    if (go_to) editor.session.go_to_step(*go_to);
    ImGui::End();
}

} // namespace trivar
