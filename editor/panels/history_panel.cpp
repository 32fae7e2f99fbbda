// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/step_title.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

StepTitle title_of(const History& history, std::size_t step)
{
    if (step == 0) return {"Empty scene", {}};
    const Document& before = step < 2 ? history.start() : history.steps()[step - 2].result;
    const History::Step& done = history.steps()[step - 1];
    return step_title(done.command, before, done.result);
}

const char* icon_of(const Command& command)
{
    const std::string_view what = verb(command);
    if (what.starts_with("add_")) return ui::icon::add;
    if (what == "import") return ui::icon::import;
    if (what == "place" || what == "edit_placement" || what == "unplace") return ui::icon::place;
    if (what == "transform" || what == "arrange") return ui::icon::move;
    if (what.ends_with("material")) return ui::icon::drop;
    if (what == "rename") return ui::icon::pencil;
    if (what == "hide") return ui::icon::hidden;
    if (what == "show") return ui::icon::eye;
    if (what == "delete") return ui::icon::trash;
    if (what == "duplicate") return ui::icon::copy;
    if (what.ends_with("group")) return ui::icon::group;
    if (what.ends_with("camera")) return ui::icon::camera;
    return ui::icon::sliders;
}

// A step; whether it was clicked.
bool draw_step(const ui::Theme& theme, const History& history, std::size_t step,
               const ui::Rect& row)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    const bool clicked = ImGui::InvisibleButton("step", {row.width(), row.height()});
    const bool present = step == history.position(), undone = step > history.position();
    const ui::Rect band = {row.lo + glm::vec2(theme.px(4), theme.px(1)),
                           row.hi - glm::vec2(theme.px(4), theme.px(1))};
    const bool hovered = ImGui::IsItemHovered();
    if (present)
        ui::paint_box(band, c.row_selected, theme.size.rounding_small);
    else if (hovered)
        ui::paint_box(band, c.row_hover, theme.size.rounding_small);
    if (step == history.position() + 1) // what is below is undone
        ui::paint_box({{row.lo.x, row.lo.y}, {row.hi.x, row.lo.y + theme.size.hairline}},
                      c.line_soft);
    const StepTitle title = title_of(history, step);
    const ui::Color quiet = present || hovered ? c.text_2 : c.text_3;
    const char* icon = step == 0 ? ui::icon::file : icon_of(history.steps()[step - 1].command);
    const float pad = theme.size.padding, left = row.lo.x + pad + theme.px(24);
    ui::paint_text(theme.font.body, {row.lo + glm::vec2(pad, 0), row.hi}, quiet, icon);
    const ImFont* font = present ? theme.font.strong : theme.font.body;
    const float most = (row.width() - theme.px(60)) / 2;
    const std::string number = ui::elided(theme.font.small, title.number, most);
    const float end =
        row.hi.x - pad - (number.empty() ? 0 : ui::text_width(theme.font.small, number) + pad);
    const std::string words = ui::elided(font, title.words, end - left);
    ui::paint_text(font, {{left, row.lo.y}, row.hi}, undone ? quiet : c.text, words);
    ui::paint_text(theme.font.small, {row.lo, row.hi - glm::vec2(pad, 0)},
                   undone ? quiet : c.text_2, number, ui::Align::right);
    if (words != title.words || number != title.number) ui::tooltip(theme, title.text());
    return clicked;
}

void draw_footer(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    const SceneFile& scene = editor.session.scene();
    const std::size_t count = scene.history().steps().size(), now = scene.history().position();
    std::string words = now < count ? fmt::format("{} of {} steps", now, count)
                                    : fmt::format("{} step{}", count, count == 1 ? "" : "s");
    if (!scene.path().empty() && scene.trouble().empty()) words += "  ·  in the scene file";
    const char* save = "Save compact...";
    const float width = ui::text_width(theme.font.body, save) + theme.px(24);
    const ui::Rect inside = {r.lo + glm::vec2(theme.size.padding, 0),
                             {r.hi.x - width - theme.px(8), r.hi.y}};
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line);
    ui::paint_text(theme.font.small, inside, c.text_3,
                   ui::elided(theme.font.small, words, inside.width()));
    ImGui::SetCursorScreenPos({r.hi.x - width, r.lo.y + theme.px(6)});
    if (ui::button(theme, save, ui::ButtonKind::quiet, {width, theme.px(28)}))
        editor.files.ask_save_compact();
    ui::tooltip(theme, "Save compact", {}, "Writes only the steps in force, under another name.");
}

} // namespace

void draw_history(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const History& history = editor.session.scene().history();
    const ui::Rect& r = layout.inspector;
    begin_panel("history", r, c.panel);
    const std::size_t count = history.steps().size();
    if (count == 0) {
        ui::empty_state(theme, r, ui::icon::history, "No steps yet",
                        "Steps appear here. Each can be returned to.");
        ImGui::End();
        return;
    }
    const float foot = theme.px(40), height = theme.px(28);
    draw_footer(editor, theme, {{r.lo.x, r.hi.y - foot}, r.hi});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("steps", {r.width(), std::max(1.0f, r.height() - foot)});
    // Follows the present when that moved, and otherwise stays where it was scrolled to.
    const auto now = static_cast<int>(history.position());
    int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("shown"), -1);
    if (shown != now) {
        const float top = height * static_cast<float>(now), view = ImGui::GetWindowHeight();
        const float scroll = ImGui::GetScrollY();
        if (top < scroll || top + height > scroll + view)
            ImGui::SetScrollY(std::max(0.0f, top - (view - height) / 2));
        shown = now;
    }
    std::optional<std::size_t> go_to;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count) + 1, height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const auto step = static_cast<std::size_t>(i); // after so many steps
            if (draw_step(theme, history, step, ui::rect_at({r.lo.x, at.y}, {r.width(), height})))
                go_to = step;
            ImGui::PopID();
        }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (go_to) editor.session.go_to_step(*go_to);
    ImGui::End();
}

} // namespace trivar
