// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/key_presets.h"
#include "editor/actions/use_keys.h"
#include "editor/panels/panels.h"
#include "editor/words/letters_in_order.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

void changed(Editor& editor, const std::string& name, std::vector<std::string> losers)
{
    auto& dialog = editor.preferences_dialog;
    dialog.given = name;
    dialog.losers = std::move(losers);
    dialog.asking.clear();
    editor.preferences.keys = changed_keys(editor.actions);
}

void paint_keys(const ui::Theme& theme, float x, const ui::Rect& row, const Action& each)
{
    for (std::size_t i = 0; i < each.keys.size(); ++i) {
        if (i > 0) {
            ui::paint_text(theme.font.small, {{x, row.lo.y}, row.hi}, theme.color.text_3, "or");
            x += theme.px(18);
        }
        for (const std::string& cap : ui::caps_of(each.keys[i]))
            x += ui::paint_keycap(theme, {x, row.lo.y}, row.height(), cap) + theme.px(4);
        x += theme.px(4);
        if (x > row.hi.x - theme.px(90)) return;
    }
    if (each.keys.empty())
        ui::paint_text(theme.font.small, {{x, row.lo.y}, row.hi}, theme.color.text_3, "no key");
}

// Draws the actions that lost their key by the last change, below the row that took it.
void draw_losers(Editor& editor, const ui::Theme& theme, const ui::Rect& row)
{
    auto& dialog = editor.preferences_dialog;
    const bool one = dialog.losers.size() == 1;
    const std::string offer = "Choose another key";
    const float width = ui::text_width(theme.font.small, offer) + theme.px(16);
    const float x = row.lo.x + theme.px(24), end = row.hi.x - (one ? width : 0);
    ui::paint_text(theme.font.small, {{x, row.lo.y}, row.hi}, theme.color.warn, ui::icon::warning);
    std::string words = "This was the key of " + listed(dialog.losers);
    if (one && action(editor, dialog.losers.front()).keys.empty()) words += ", which now has none";
    ui::paint_text(theme.font.small, {{x + theme.px(20), row.lo.y}, row.hi}, theme.color.warn,
                   ui::elided(theme.font.small, words + ".", end - x - theme.px(28)));
    if (!one) return;
    ImGui::SetCursorScreenPos({end, row.lo.y + theme.px(2)});
    if (ui::button(theme, offer, ui::ButtonKind::quiet, {width, row.height() - theme.px(4)})) {
        dialog.asking = dialog.losers.front();
        dialog.show_asking = true;
        dialog.filter.clear(); // its row may not be among those that were looked for
        dialog.sought.reset();
    }
}

void draw_row(Editor& editor, const ui::Theme& theme, const ui::Rect& row, const Action& each)
{
    const ui::Palette& c = theme.color;
    auto& dialog = editor.preferences_dialog;
    const bool asking = dialog.asking == each.name, own = each.keys != each.usual_keys;
    const float keys = row.lo.x + std::round(row.width() * 0.46f);
    const glm::vec2 square(theme.size.icon_button);
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    const float button = row.width() - (own ? square.x + theme.px(8) : 0);
    const bool clicked = ImGui::InvisibleButton("keys", {button, row.height()});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered || asking) ui::paint_box(row, c.row_hover, theme.size.rounding);
    if (own) ui::paint_dot({row.lo.x + theme.px(12), row.center().y}, theme.px(2), c.changed);
    ui::paint_text(theme.font.body, {{row.lo.x + theme.px(24), row.lo.y}, row.hi}, c.text,
                   ui::elided(theme.font.body, each.name, keys - row.lo.x - theme.px(36)));
    if (asking) {
        const ui::Rect field = ui::rect_at({keys - theme.px(8), row.lo.y + theme.px(3)},
                                           {theme.px(150), row.height() - theme.px(6)});
        ui::paint_box(field, c.field_active, theme.size.rounding);
        ui::paint_rim(field, c.focus, theme.size.rounding, 1.5f * theme.scale);
        ui::paint_text(theme.font.body, field, c.text_2, "Press the new key", ui::Align::center);
    } else {
        paint_keys(theme, keys, row, each);
        if (hovered) ui::tooltip({"Change the key", {}, "Click, then press it; Esc leaves it."});
    }
    if (clicked) {
        dialog.asking = asking ? "" : each.name;
        dialog.seeking = false;
    }
    if (!own) return;
    ImGui::SetCursorScreenPos({row.hi.x - square.x - theme.px(4), row.center().y - square.y / 2});
    if (ui::icon_button(theme, "reset", ui::icon::reset, square, {"Restore the default key"})) {
        const std::string name = each.name;
        changed(editor, name, give_usual_keys(editor.actions, name));
    }
}

void draw_rows(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    auto& dialog = editor.preferences_dialog;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("keys", {r.width(), r.height()});
    const ImVec2 top = ImGui::GetCursorScreenPos();
    const float height = theme.px(30), end = r.hi.x - theme.px(12);
    float y = top.y;
    std::string menu;
    for (std::size_t i = 0; i < editor.actions.size(); ++i) {
        const Action& each = editor.actions[i];
        if (!letters_in_order(dialog.filter, each.name)) continue;
        if (dialog.sought && !std::ranges::count(each.keys, *dialog.sought)) continue;
        if (each.menu != menu) {
            menu = each.menu;
            ui::paint_text(theme.font.strong,
                           {{r.lo.x + theme.px(8), y + theme.px(8)}, {end, y + theme.px(36)}},
                           theme.color.text, menu);
            y += theme.px(36);
        }
        const ui::Rect row = {{r.lo.x, y}, {end, y + height}};
        y += height;
        if (dialog.show_asking && dialog.asking == each.name) {
            ImGui::SetScrollY(std::max(0.0f, row.lo.y - top.y - r.height() / 3));
            dialog.show_asking = false;
        }
        ImGui::PushID(static_cast<int>(i));
        draw_row(editor, theme, row, each);
        if (dialog.given == each.name && !dialog.losers.empty()) {
            draw_losers(editor, theme, {{r.lo.x, y}, {end, y + theme.px(26)}});
            y += theme.px(26);
        }
        ImGui::PopID();
    }
    if (y == top.y)
        ui::empty_state(
            theme, r, ui::icon::search,
            dialog.sought ? "No command has this key" : "No command is called that",
            dialog.sought
                ? "Look for another key, or click the row of a command to give it this one."
                : "Take letters away to see more of them.");
    ImGui::SetCursorScreenPos(top);
    ImGui::Dummy({1, y - top.y + theme.px(8)});
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// A field that waits for a key, and then shows only whose it is.
void draw_key_seeker(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    auto& dialog = editor.preferences_dialog;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    const bool clicked = ImGui::InvisibleButton("seek", {r.width(), r.height()});
    const bool hovered = ImGui::IsItemHovered();
    ui::paint_box(r,
                  dialog.seeking ? c.field_active
                  : hovered      ? c.field_hover
                                 : c.field,
                  theme.size.rounding_small);
    if (dialog.seeking) ui::paint_rim(r, c.focus, theme.size.rounding_small, 1.5f * theme.scale);
    const ui::Rect in = {r.lo + glm::vec2(theme.px(8), 0), r.hi - glm::vec2(theme.px(8), 0)};
    ui::paint_text(theme.font.body, in, c.text_2, ui::icon::keyboard);
    const float x = in.lo.x + theme.px(24);
    if (dialog.sought) {
        float at = x;
        for (const std::string& cap : ui::caps_of(*dialog.sought))
            at += ui::paint_keycap(theme, {at, r.lo.y}, r.height(), cap) + theme.px(4);
        ui::paint_text(theme.font.body, in, c.text_2, ui::icon::close, ui::Align::right);
    } else {
        ui::paint_text(theme.font.body, {{x, in.lo.y}, in.hi}, dialog.seeking ? c.text_2 : c.text_3,
                       dialog.seeking ? "Press it now" : "Find by key");
    }
    if (!clicked) return;
    dialog.seeking = !dialog.sought && !dialog.seeking;
    dialog.sought.reset();
    dialog.asking.clear();
}

// Whole key maps; one that was changed by hand is none of them.
void draw_presets(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    int chosen = -1;
    std::vector<std::string> names;
    for (const KeyPreset& preset : key_presets()) {
        std::vector<Action> actions = editor.actions;
        use_keys(actions, preset.keys);
        if (changed_keys(actions) == changed_keys(editor.actions))
            chosen = static_cast<int>(names.size());
        names.push_back(preset.name);
    }
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    if (ui::segments(theme, "presets", chosen, names, std::min(theme.px(360), r.width())) !=
        ui::Edit::changed)
        return;
    use_keys(editor.actions, key_presets()[static_cast<std::size_t>(chosen)].keys);
    editor.preferences.keys = changed_keys(editor.actions);
    editor.preferences_dialog.asking.clear();
    editor.preferences_dialog.given.clear();
}

} // namespace

void draw_key_map(Editor& editor, const ui::Theme& theme, const ui::Rect& page)
{
    auto& dialog = editor.preferences_dialog;
    if (!dialog.asking.empty())
        if (const auto chord = ui::struck_chord()) {
            const std::string name = dialog.asking;
            if (*chord == ui::Chord{ui::key_escape})
                dialog.asking.clear();
            else
                changed(editor, name, give_key(editor.actions, name, *chord));
        }
    if (dialog.seeking)
        if (const auto chord = ui::struck_chord()) {
            dialog.seeking = false;
            if (*chord != ui::Chord{ui::key_escape}) dialog.sought = chord;
        }
    draw_presets(editor, theme, {{page.lo.x, page.lo.y + theme.px(12)}, page.hi});
    const float y = page.lo.y + theme.px(44), seeker = theme.px(200);
    const float end = page.hi.x - theme.px(12), field = end - seeker - theme.px(8) - page.lo.x;
    ImGui::SetCursorScreenPos({page.lo.x, y});
    ui::text_field(theme, "filter", dialog.filter, "Find a command", field, ui::icon::search);
    draw_key_seeker(editor, theme, {{end - seeker, y}, {end, y + theme.size.row}});
    draw_rows(editor, theme, {{page.lo.x, page.lo.y + theme.px(76)}, page.hi});
}

} // namespace trivar
