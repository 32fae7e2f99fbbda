// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "ui/tooltip.h"

#include <imgui.h>

namespace trivar {

void draw_tabs(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.tabs;
    begin_panel("tabs", r, c.panel);
    float x = r.lo.x + theme.px(8);
    const auto tab = [&](Editor::Tab which, const std::string& name, const char* says) {
        const bool on = editor.tab == which;
        const float width = ui::text_width(theme.font.strong, name) + theme.px(20);
        const ui::Rect at = ui::rect_at({x, r.lo.y + theme.px(8)}, {width, theme.size.row});
        ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
        if (ImGui::InvisibleButton(name.c_str(), {width, at.height()})) editor.tab = which;
        ui::tooltip({name, {}, says});
        if (on || ImGui::IsItemHovered())
            ui::paint_box(at, on ? c.field : c.row_hover, theme.size.rounding);
        ui::paint_text(on ? theme.font.strong : theme.font.body, at, on ? c.text : c.text_2, name,
                       ui::Align::center);
        x += width + theme.px(4);
    };
    tab(Editor::Tab::inspector, "Inspector", "Properties of the selection.");
    tab(Editor::Tab::history, "History", "Every step so far; each can be returned to.");
    tab(Editor::Tab::log, "Log", "The commands of the scene file; you can type more.");
    ImGui::End();
}

} // namespace trivar
