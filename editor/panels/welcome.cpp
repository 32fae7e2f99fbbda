// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

constexpr std::size_t most_samples = 6, most_recent = 4;

float caption(const ui::Theme& theme, const ui::Rect& column, float y, const char* words)
{
    ui::paint_text(theme.font.small_strong, {{column.lo.x, y}, {column.hi.x, y + theme.px(20)}},
                   theme.color.text_3, words);
    return y + theme.px(28);
}

// A scene of the list; whether it was clicked. One that is gone is dim.
bool recent_row(const ui::Theme& theme, const ui::Rect& row, const RecentScene& scene)
{
    const ui::Palette& c = theme.color;
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    const bool clicked = ImGui::InvisibleButton("recent", {row.width(), row.height()});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui::paint_box(row, c.row_hover, theme.size.rounding);
    ui::tooltip(theme, scene.there ? scene.path : "It is not there any more", {},
                scene.there ? "" : "Click to look for it.");
    const float x = row.lo.x + theme.px(32), end = row.hi.x - theme.px(8);
    const ui::Color quiet = !scene.there ? c.text_off : hovered ? c.text_2 : c.text_3;
    ui::paint_text(theme.font.body, {row.lo + glm::vec2(theme.px(10), 0), row.hi}, quiet,
                   ui::icon::file);
    const std::string name = ui::elided(theme.font.body, scene.name, (end - x) * 0.7f);
    ui::paint_text(theme.font.body, {{x, row.lo.y}, row.hi}, scene.there ? c.text : c.text_off,
                   name);
    const float left = x + ui::text_width(theme.font.body, name) + theme.px(12);
    ui::paint_text(theme.font.small, {{left, row.lo.y}, {end, row.hi.y}}, quiet,
                   ui::elided(theme.font.small, scene.folder, end - left), ui::Align::right);
    return clicked;
}

// The program's name and the ways to begin; returns where it ends.
void draw_beginnings(Editor& editor, const ui::Theme& theme, const ui::Rect& column)
{
    const ui::Palette& c = theme.color;
    float y = column.lo.y;
    const auto fits = [&](float height) { return y + height <= column.hi.y + theme.px(20); };
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
        if (!fits(theme.px(36))) return;
        ImGui::SetCursorScreenPos({column.lo.x, y});
        const Action& each = action(editor, what);
        if (ui::button(theme, words, kind, {column.width(), theme.px(36)}, icon, key_text(each)))
            each.run(editor);
        y += theme.px(44);
    };
    line("Import a model...", ui::icon::import, "Import model...", ui::ButtonKind::primary);
    line("Open a scene...", ui::icon::open_file, "Open...", ui::ButtonKind::plain);
    const auto& recent = editor.recent_scenes.of(editor.preferences.recent_scenes);
    y += theme.px(8);
    if (recent.empty() || !fits(theme.px(60))) return;
    y = caption(theme, column, y, "RECENT");
    std::string open;
    for (std::size_t i = 0; i < std::min(most_recent, recent.size()) && fits(theme.px(32)); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (recent_row(theme, ui::rect_at({column.lo.x, y}, {column.width(), theme.px(32)}),
                       recent[i])) {
            if (recent[i].there)
                open = recent[i].path;
            else
                editor.files.ask_open();
        }
        ImGui::PopID();
        y += theme.px(32);
    }
    if (!open.empty()) editor.files.open_scene(open);
}

void draw_samples(Editor& editor, const ui::Theme& theme, const ui::Rect& column)
{
    float y = caption(theme, column, column.lo.y + theme.px(8), "SAMPLE SCENES");
    const auto& samples = editor.files.samples;
    for (std::size_t i = 0; i < std::min(most_samples, samples.size()); ++i) {
        if (y + theme.px(32) > column.hi.y + theme.px(20)) return;
        ImGui::SetCursorScreenPos({column.lo.x, y});
        if (ui::button(theme, scene_title(samples[i]), ui::ButtonKind::plain,
                       {column.width(), theme.px(32)}, ui::icon::scene))
            editor.files.open_scene(samples[i]);
        y += theme.px(38);
    }
}

} // namespace

void draw_welcome(Editor& editor, const ui::Theme& theme, const ui::Rect& view)
{
    const ui::Palette& c = theme.color;
    const float pad = theme.px(28);
    const auto samples = static_cast<float>(std::min(most_samples, editor.files.samples.size()));
    const auto recent =
        static_cast<float>(std::min(most_recent, editor.preferences.recent_scenes.size()));
    const bool two_columns = samples > 0 && view.width() >= theme.px(544);
    const float beginnings = theme.px(166) + (recent > 0 ? theme.px(36 + 32 * recent) : 0);
    const float height = std::max(beginnings, two_columns ? theme.px(36 + 38 * samples) : 0);
    const glm::vec2 wanted{theme.px(two_columns ? 640 : 360), height + 2 * pad - theme.px(6)};
    const glm::vec2 size = glm::min(wanted, view.size() - theme.px(24));
    const ui::Rect r = ui::rect_at(glm::round(view.center() - size / 2.0f), size);
    ui::paint_card(theme, r);
    const float column =
        two_columns ? std::round((r.width() - 3 * pad) * 0.55f) : r.width() - 2 * pad;
    draw_beginnings(editor, theme, {r.lo + pad, {r.lo.x + pad + column, r.hi.y - pad}});
    if (two_columns) {
        const float x = r.lo.x + 2 * pad + column;
        ui::paint_box(
            {{x - pad / 2, r.lo.y + pad}, {x - pad / 2 + theme.size.hairline, r.hi.y - pad}},
            c.line_soft);
        draw_samples(editor, theme, {{x, r.lo.y + pad}, r.hi - pad});
    }
    // A drop needs no button, only to be known.
    const ui::Rect drop = {{r.lo.x, r.hi.y + theme.px(12)}, {r.hi.x, r.hi.y + theme.px(52)}};
    if (drop.hi.y < view.hi.y - theme.px(8)) {
        ui::paint_box(drop, c.chip, theme.size.rounding_card);
        const std::string words = "Or drop a file anywhere:  glTF, OBJ, PLY, STL, OFF, .trivar";
        ui::paint_text(theme.font.body, drop, c.chip_text,
                       ui::elided(theme.font.body, words, drop.width() - theme.px(24)),
                       ui::Align::center);
    }
}

} // namespace trivar
