// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include "ui/dialog.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {
namespace {

struct Line {
    std::string what, how;
};

// What the tool at hand says of itself, as the status line does.
std::vector<Line> lines_of_tool(const Editor& editor)
{
    const Tool& tool = *editor.tools[editor.tool];
    std::vector<Line> lines{{tool.name(), ""}, {tool.help(), " "}};
    for (const Hint& hint : tool.hints(editor.session)) {
        std::string how;
        for (const std::string& input : inputs_now(editor, hint)) {
            const bool first = how.empty() || how.ends_with(' ');
            how += input == "/" ? " or " : (first ? "" : "+") + input;
        }
        if (!how.empty()) lines.push_back({hint.verb, how});
    }
    return lines;
}

// From the tables that the program works by, so that it cannot tell anything else.
std::vector<Line> lines_of(const Editor& editor)
{
    std::vector<Line> lines = lines_of_tool(editor);
    const std::vector<Line> mouse{{"Mouse", ""},
                                  {"Use the tool", "left"},
                                  {"Orbit about the point under the mouse", "middle, or Alt+left"},
                                  {"Pan", "Shift+middle, or Alt+Shift+left"},
                                  {"Zoom to the mouse", "wheel, or Ctrl+middle"},
                                  {"Cancel a gesture", "right, or Esc"},
                                  {"Type a number", "click it"},
                                  {"Drag finely", "hold Shift"},
                                  {"While moving, rotating or scaling", ""},
                                  {"Along one axis; again: the object's own", "X, Y, Z"},
                                  {"In the plane across it", "Shift+X, Shift+Y, Shift+Z"},
                                  {"An exact amount, then the next", "type it, Tab"},
                                  {"Snap", "hold Ctrl"},
                                  {"Done", "left, or Enter"}};
    lines.insert(lines.end(), mouse.begin(), mouse.end());
    std::string menu;
    for (const Action& each : editor.actions) {
        if (each.keys.empty()) continue;
        if (each.menu != menu) lines.push_back({each.menu, ""});
        menu = each.menu;
        std::string keys;
        for (const ui::Chord& chord : each.keys)
            keys += (keys.empty() ? "" : ", ") + ui::text_of(chord);
        lines.push_back({each.name, keys});
    }
    return lines;
}

} // namespace

void draw_help(Editor& editor, const ui::Theme& theme)
{
    if (!editor.help_open) return;
    const ui::Palette& c = theme.color;
    const ui::Rect r = ui::begin_dialog(theme, "help", {theme.px(560), theme.px(560)});
    const float pad = theme.px(24), line = theme.px(24);
    ui::paint_text(theme.font.title,
                   ui::rect_at(r.lo + glm::vec2(pad, theme.px(16)), {r.width(), theme.px(24)}),
                   c.text, "Keys and mouse");
    ImGui::SetCursorScreenPos({r.lo.x + pad, r.lo.y + theme.px(52)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("keys", {r.width() - 2 * pad, r.height() - theme.px(52) - theme.px(68)});
    for (const Line& each : lines_of(editor)) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x - theme.px(12);
        const bool heading = each.how.empty();
        const ui::Rect row = ui::rect_at({at.x, at.y + (heading ? theme.px(8) : 0)}, {width, line});
        ui::paint_text(heading ? theme.font.strong : theme.font.body, row,
                       heading ? c.text : c.text_2, each.what);
        ui::paint_text(theme.font.body, row, c.text, each.how, ui::Align::right);
        ImGui::Dummy({1, line + (heading ? theme.px(8) : 0)});
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::SetCursorScreenPos({r.hi.x - pad - theme.px(80), r.hi.y - theme.px(20) - theme.px(32)});
    if (ui::button(theme, "Close", ui::ButtonKind::primary) ||
        ImGui::IsKeyPressed(ui::key_escape, false)) {
        editor.help_open = false;
        ImGui::CloseCurrentPopup();
    }
    ui::end_dialog();
}

} // namespace trivar
