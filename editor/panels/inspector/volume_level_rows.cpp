// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/volume_level_rows.h"

#include "editor/panels/inspector/field_rows.h"
#include "editor/session/volume_levels.h"
#include "ui/icons.h"
#include "ui/level_field.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/color_space.hpp>
#include <imgui.h>

namespace trivar {
namespace {

// A square of a colour that opens a picker.
ui::Edit swatch(const ui::Theme& theme, const ui::Rect& r, ui::Color color, glm::vec3& srgb)
{
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    if (ImGui::InvisibleButton("swatch", {r.width(), r.height()})) ImGui::OpenPopup("pick");
    const bool hot = ImGui::IsItemHovered();
    ui::tooltip({"Colour of the level", {}, "Of its lines, and a paler one of its surface."});
    const ui::Rect box = ui::rect_at(glm::round(r.center() - theme.px(8)), glm::vec2(theme.px(16)));
    ui::paint_box(box, color, theme.size.rounding_small);
    ui::paint_rim(box, hot ? theme.color.text : theme.color.raised_rim, theme.size.rounding_small,
                  theme.size.hairline);
    ui::Edit edit = ui::Edit::none;
    if (!ImGui::BeginPopup("pick")) return edit;
    ImGui::SetNextItemWidth(theme.px(200));
    if (ImGui::ColorPicker3("##picker", &srgb.x,
                            ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_DisplayHex |
                                ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoOptions))
        edit = ui::Edit::changed;
    ImGui::EndPopup();
    return edit;
}

ui::Edit toggle(const ui::Theme& theme, const char* id, const char* icon, glm::vec2 at, bool& on,
                const ui::Tip& tip)
{
    const ui::Rect r = ui::rect_at(at, glm::vec2(theme.size.row));
    ImGui::SetCursorScreenPos({at.x, at.y});
    const bool pressed = ImGui::InvisibleButton(id, {r.width(), r.height()});
    const bool hot = ImGui::IsItemHovered();
    ui::tooltip(tip);
    if (hot) ui::paint_box(r, theme.color.field_hover, theme.size.rounding_small);
    ui::paint_text(theme.font.body, r, on ? theme.color.text : theme.color.text_off, icon,
                   ui::Align::center);
    if (pressed) on = !on;
    return pressed ? ui::Edit::changed : ui::Edit::none;
}

ui::NumberStyle value_style(const LevelRows& of)
{
    ui::NumberStyle style{.lo = -1e30, .hi = 1e30, .unit = of.unit};
    if (of.shown && of.shown->summary) {
        style.lo = of.shown->summary->least;
        style.hi = style.bar_hi = of.shown->summary->greatest;
    }
    return style;
}

void level_row(ValueRows& rows, const LevelRows& of, VoxelLevel& level, int number, int& chosen)
{
    const ui::Theme& theme = rows.theme;
    const ui::Palette& c = theme.color;
    const float side = theme.size.row, pad = theme.size.padding;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x;
    const bool lit = number == chosen;
    if (lit) // from the padding on, so that it stands apart from the panel's edge
        ui::paint_box({{left + pad - theme.px(4), top.y - theme.px(2)},
                       {left + ImGui::GetWindowWidth() - theme.px(8), top.y + side + theme.px(2)}},
                      c.row_selected, theme.size.rounding_small);
    const float icons = 3 * side;
    const float begin = left + pad, field = begin + theme.size.label;
    const float end = left + ImGui::GetWindowWidth() - theme.px(ui::key_gutter);
    glm::vec3 color = level.ink.color;
    const ui::Edit colored =
        swatch(theme, ui::rect_at({begin, top.y}, {theme.px(20), side}),
               level.hidden ? ui::faded(level_color(level), 0.4f) : level_color(level), color);
    if (colored != ui::Edit::none) set_color(level, color);
    rows.take(colored);
    const ui::Rect name{{begin + theme.px(24), top.y}, {field - theme.px(4), top.y + side}};
    ImGui::SetCursorScreenPos({name.lo.x, name.lo.y});
    if (ImGui::InvisibleButton("name", {name.width(), name.height()})) chosen = number;
    const std::string words = level.name.empty() ? fmt::format("Level {}", number + 1) : level.name;
    ui::tooltip({words, {}, "Click to choose it."});
    ui::paint_text(lit ? theme.font.strong : theme.font.body, name,
                   level.hidden ? c.text_2 : c.text,
                   ui::elided(lit ? theme.font.strong : theme.font.body, words, name.width()));
    ImGui::SetCursorScreenPos({field, top.y});
    if (rows.keys)
        rows.keys->mark(theme, {.width = end - field}, {of.parameter(number) + ".value"});
    ImGui::SetCursorScreenPos({field, top.y});
    const ui::Edit valued = ui::number_field(theme, "value", level.value, value_style(of),
                                             end - field - icons - theme.px(4));
    if (valued == ui::Edit::changed && of.shown && of.shown->summary) chosen = number;
    rows.take(valued);
    const float bottom = ImGui::GetCursorScreenPos().y;
    bool shown = !level.hidden;
    rows.take(toggle(theme, "lines", ui::icon::place, {end - icons, top.y}, level.lines,
                     {level.lines ? "Lines are drawn" : "No lines"}));
    rows.take(toggle(theme, "surface", ui::icon::mesh, {end - icons + side, top.y}, level.surface,
                     {level.surface ? "Its surface is shown" : "No surface"}));
    rows.take(toggle(theme, "eye", shown ? ui::icon::eye : ui::icon::hidden, {end - side, top.y},
                     shown, {shown ? "Hide the level" : "Show the level"}));
    level.hidden = !shown;
    ImGui::SetCursorScreenPos({top.x, bottom});
}

} // namespace

std::string LevelRows::parameter(int number) const
{
    return fmt::format("shape.levels.{}", number);
}

void draw_level_histogram(ValueRows& rows, const LevelRows& of, VoxelShape& shape, int& chosen)
{
    if (!of.shown || !of.shown->summary) return;
    const ui::Theme& theme = rows.theme;
    const VolumeSummary& s = *of.shown->summary;
    std::vector<ui::LevelMark> marks;
    for (const VoxelLevel& level : shape.levels)
        marks.push_back(
            {level.value, level_color(level), value_words(level.value, of.unit), level.hidden});
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    ui::LevelStyle style{.counts = s.histogram,
                         .lo = s.least,
                         .hi = s.greatest,
                         .ends = {ui::short_number(s.least), ui::short_number(s.greatest)},
                         .height = 116,
                         .strip = 30};
    if (of.scouted) {
        style.curve = of.scouted->curve;
        style.snaps = of.scouted->plateaus;
    }
    const ui::Edit edit = ui::level_field(theme, "histogram", marks, chosen, style, width);
    ui::tooltip({"Histogram",
                 {},
                 "How often values occur, and below it how much line a level there has. Dots are "
                 "where that hardly changes: a body is there. Drag a level, which halts at dots, "
                 "with Ctrl anywhere; a double click types."});
    if (edit == ui::Edit::changed && chosen >= 0)
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i].value != shape.levels[i].value)
                shape.levels[i].value = readable_value(marks[i].value, s);
    rows.take(edit);
    ui::gap(theme, 6);
}

void draw_level_list(ValueRows& rows, const LevelRows& of, VoxelShape& shape, int& chosen)
{
    for (std::size_t i = 0; i < shape.levels.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        level_row(rows, of, shape.levels[i], static_cast<int>(i), chosen);
        ImGui::PopID();
    }
}

} // namespace trivar
