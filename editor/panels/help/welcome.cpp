// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/help/welcome.h"
#include "editor/actions/help_actions.h"
#include "editor/panels/panels.h"
#include "editor/session/recent_scenes.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>
#include <imgui.h>

namespace trivar {
namespace {

constexpr std::size_t most_recent = 4;
constexpr float row_height = 44;

// A scene of the list; whether it was clicked. One that is gone is dim.
bool recent_row(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
                const RecentScene& scene)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    const bool clicked = ImGui::InvisibleButton("recent", {row.width(), row.height()});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui::paint_box(row, c.row_hover, theme.size.rounding);
    ui::tooltip({scene.there ? scene.path : "This file no longer exists",
                 {},
                 scene.there ? "" : "Click to look for it."});
    const ui::Color quiet = hovered ? c.text_2 : c.text_3;
    const ui::Rect first = {row.lo, {row.hi.x, row.lo.y + theme.px(24)}};
    const ui::Rect second = {{row.lo.x, row.lo.y + theme.px(20)}, row.hi};
    const float x = row.lo.x + theme.px(24), end = row.hi.x - theme.px(4);
    ui::paint_text(theme.font.body, {first.lo + glm::vec2(theme.px(2), 0), first.hi},
                   scene.there ? c.text_2 : c.text_off, ui::icon::file);
    const std::string when = scene.there ? day_words(scene.changed, std::time(nullptr)) : "Locate";
    const float right = ui::text_width(theme.font.small, when);
    ui::paint_text(theme.font.small, {{x, first.lo.y}, {end, first.hi.y}},
                   scene.there ? quiet : c.accent_text, when, ui::Align::right);
    ui::paint_text(theme.font.body, {{x, first.lo.y}, first.hi}, scene.there ? c.text : c.text_off,
                   ui::elided(theme.font.body, scene.name, end - right - theme.px(12) - x));
    ui::paint_text(theme.font.small, {{x, second.lo.y}, second.hi},
                   scene.there ? quiet : c.text_off,
                   ui::elided(theme.font.small, scene.folder, end - x));
    return is_chosen(editor, theme, row, clicked);
}

// Draws the recent scenes, as many as fit; returns where they end.
float draw_recent(Editor& editor, const ui::Theme& theme, const ui::Rect& column, float y)
{
    const auto& recent = editor.memory.of<RecentScenes>().of(editor.preferences.recent_scenes);
    const float row = theme.px(row_height);
    if (recent.empty() || y + theme.px(28) + row > column.hi.y) return y;
    y = draw_caption(theme, column, y, "RECENT");
    std::string open;
    bool look = false;
    for (std::size_t i = 0; i < std::min(most_recent, recent.size()) && y + row <= column.hi.y;
         ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (recent_row(editor, theme, ui::rect_at({column.lo.x, y}, {column.width(), row}),
                       recent[i])) {
            if (recent[i].there)
                open = recent[i].path;
            else
                look = true;
        }
        ImGui::PopID();
        y += row;
    }
    if (!open.empty()) editor.files.open_scene(open);
    if (look) editor.files.ask_open();
    return y;
}

// Draws as many lines as fit.
void tell_of_lacking(const ui::Theme& theme, const ui::Rect& r)
{
    float y = r.lo.y;
    for (const std::string& words :
         ui::wrapped(theme.font.small,
                     "Sample scenes and manual were not found: share/trivar is not where the "
                     "program was installed.",
                     r.width())) {
        if (y + theme.px(18) > r.hi.y) return;
        ui::paint_text(theme.font.small, {{r.lo.x, y}, {r.hi.x, y + theme.px(18)}},
                       theme.color.warn, words);
        y += theme.px(18);
    }
}

// The program's name and the ways to begin.
void draw_beginnings(Editor& editor, const ui::Theme& theme, const ui::Rect& column, bool tour)
{
    const ui::Palette& c = theme.color;
    float y = column.lo.y;
    const auto left = editor.recovery.left_scene();
    const float foot = (left ? theme.px(28) : 0) + (tour ? theme.px(28) : 0);
    const ui::Rect upper = {column.lo, {column.hi.x, column.hi.y - foot}};
    ui::paint_text(theme.font.display, {{column.lo.x, y}, {column.hi.x, y + theme.px(36)}}, c.text,
                   "Trivar");
    y += theme.px(42);
    for (const std::string& words : ui::wrapped(
             theme.font.body, "Draw one stroke. The model lies along it.", column.width())) {
        ui::paint_text(theme.font.body, {{column.lo.x, y}, {column.hi.x, y + theme.px(20)}},
                       c.text_2, words);
        y += theme.px(20);
    }
    y += theme.px(16);
    const auto line = [&](const char* words, const char* icon, const char* what,
                          ui::ButtonKind kind) {
        if (y + theme.px(36) > upper.hi.y) return;
        ImGui::SetCursorScreenPos({column.lo.x, y});
        const Action& each = action(editor, what);
        const ui::Rect r = ui::rect_at({column.lo.x, y}, {column.width(), theme.px(36)});
        const bool clicked = ui::button(theme, words, kind, r.size(), icon, key_text(each));
        if (is_chosen(editor, theme, r, clicked)) each.run(editor);
        y += theme.px(44);
    };
    line("New scene", ui::icon::file, "New scene", ui::ButtonKind::primary);
    line("Open...", ui::icon::open_file, "Open...", ui::ButtonKind::plain);
    line("Import model...", ui::icon::import, "Import model...", ui::ButtonKind::plain);
    y = draw_recent(editor, theme, upper, y + theme.px(8));
    if (editor.start_card.lacks_samples)
        tell_of_lacking(theme, {{column.lo.x, y + theme.px(8)}, upper.hi});
    y = upper.hi.y;
    const auto foot_link = [&](const std::string& words) {
        const ui::Rect row = {{column.lo.x, y}, {column.hi.x, y + theme.px(28)}};
        y = row.hi.y;
        return text_link(editor, theme, row, words);
    };
    std::string when = left ? day_words(left->when, std::time(nullptr)) : "";
    for (const std::string_view day : {"Today", "Yesterday"}) // a month keeps its capital
        if (when.starts_with(day)) when[0] = static_cast<char>(std::tolower(day[0]));
    if (left && foot_link("Recover a scene from " + when)) editor.files.recover();
    if (tour && foot_link("Take the one-minute tour")) begin_tour(editor);
}

void paint_dashed(const ui::Rect& r, ui::Color color, float dash, float thickness)
{
    for (float x = r.lo.x; x < r.hi.x; x += 2 * dash)
        for (const float y : {r.lo.y, r.hi.y})
            ui::paint_line({x, y}, {std::min(x + dash, r.hi.x), y}, color, thickness);
    for (float y = r.lo.y; y < r.hi.y; y += 2 * dash)
        for (const float x : {r.lo.x, r.hi.x})
            ui::paint_line({x, y}, {x, std::min(y + dash, r.hi.y)}, color, thickness);
}

// A drop needs no button, only to be known.
void draw_drop_target(const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    const std::string bold = "Drop a file anywhere",
                      formats = "glTF, OBJ, PLY, STL, OFF  ·  volume data  ·  Trivar scenes";
    ui::paint_box(r, c.chip, theme.size.rounding_small);
    paint_dashed(r, ui::faded(c.chip_text, 0.6f), theme.px(4), theme.size.hairline);
    const float icon = theme.px(24), gap = theme.px(16);
    const float first = ui::text_width(theme.font.strong, bold),
                second = ui::text_width(theme.font.body, formats);
    const bool all = icon + first + gap + second < r.width() - theme.px(24);
    const float width = icon + first + (all ? gap + second : 0);
    float x = std::round(r.center().x - width / 2);
    const auto write = [&](const ImFont* font, const std::string& words, float by) {
        ui::paint_text(font, {{x, r.lo.y}, {r.hi.x, r.hi.y}}, c.chip_text, words);
        x += by;
    };
    write(theme.font.body, ui::icon::import, icon);
    write(theme.font.strong, bold, first + gap);
    if (all) write(theme.font.body, formats, second);
}

} // namespace

void draw_welcome(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const float pad = theme.px(30), drop = theme.px(56), below = theme.px(16);
    const std::vector<Sample> samples = samples_among(editor.files.samples);
    const bool two_columns = !samples.empty() && view.width() >= theme.px(544);
    const glm::vec2 wanted{theme.px(two_columns ? 832 : 360), theme.px(two_columns ? 478 : 440)};
    const bool roomy = view.height() > theme.px(440);
    const glm::vec2 room = view.size() - glm::vec2(theme.px(24), theme.px(24)) -
                           glm::vec2(0, roomy ? drop + below : 0);
    const glm::vec2 size = glm::min(wanted, room);
    glm::vec2 at = glm::round(view.center() - size / 2.0f);
    if (roomy) at.y = std::round(at.y - (drop + below) / 2);
    const ui::Rect r = ui::rect_at(at, size);
    ui::paint_card(theme, r);
    move_keyboard(editor);
    ui::lower_area("start card", r);
    const float inner = r.width() - 2 * pad;
    const float column = two_columns ? std::max(std::round(inner * 0.366f), theme.px(232)) : inner;
    draw_beginnings(editor, theme, {r.lo + pad, {r.lo.x + pad + column, r.hi.y - pad}},
                    !two_columns && has_tour(editor));
    if (two_columns) {
        const float x = r.lo.x + pad + column + theme.px(20);
        ui::paint_box({{x, r.lo.y + pad}, {x + theme.size.hairline, r.hi.y - pad}},
                      theme.color.line_soft);
        draw_samples(editor, theme,
                     {{x + theme.px(20), r.lo.y + pad}, r.hi - glm::vec2(pad, pad - theme.px(10))},
                     samples);
    }
    if (roomy) draw_drop_target(theme, {{r.lo.x, r.hi.y + below}, {r.hi.x, r.hi.y + below + drop}});
    if (editor.start_card.asked != editor.session.scenes()) return;
    const ui::Rect corner = ui::rect_at({r.hi.x - theme.px(28), r.lo.y + theme.px(4)},
                                        glm::vec2(theme.size.icon_button));
    ImGui::SetCursorScreenPos({corner.lo.x, corner.lo.y});
    const bool clicked =
        ui::icon_button(theme, "close", ui::icon::close, corner.size(), {"Close", "Esc"});
    if (is_chosen(editor, theme, corner, clicked)) editor.start_card.asked = -1;
}

} // namespace trivar
