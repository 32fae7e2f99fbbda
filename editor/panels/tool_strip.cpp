// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {

void draw_tool_strip(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Rect& r = layout.strip;
    begin_panel("tool strip", r, theme.color.panel);
    for (std::size_t i = 0; i < editor.tools.size(); ++i) {
        const Tool& tool = *editor.tools[i];
        const ui::Rect place = layout.tool_place(theme, i);
        ImGui::SetCursorScreenPos({place.lo.x, place.lo.y});
        if (ui::icon_button(theme, tool.name(), tool.facts().icon, place.size(),
                            tip_of(editor, action(editor, tool.name()), tool.facts().help),
                            {.on = i == editor.tool}))
            editor.choose_tool(i);
    }
    ImGui::End();
}

void draw_options_bar(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.options;
    begin_panel("options bar", r, c.header);
    Tool& tool = editor.active_tool();
    float x = r.lo.x + theme.px(12);
    ui::paint_text(theme.font.body, {{x, r.lo.y}, r.hi}, c.accent_text, tool.facts().icon);
    x += theme.px(24);
    ui::paint_text(theme.font.strong, {{x, r.lo.y}, r.hi}, c.text, tool.name());
    x += ui::text_width(theme.font.strong, tool.name()) + theme.px(16);
    ui::paint_box({{x, r.lo.y + theme.px(12)}, {x + theme.size.hairline, r.hi.y - theme.px(12)}},
                  c.line_soft);
    x += theme.px(16);
    ImGui::SetCursorScreenPos({x, r.lo.y + theme.px(8)});
    tool.options(editor.session, theme, r.hi.x - theme.px(12) - x);
    ImGui::End();
}

} // namespace trivar
