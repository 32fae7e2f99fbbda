// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_palette.h"
#include "editor/panels/panels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace trivar {
namespace {

// The name with the letters that matched in the accent; returns where it ends.
float paint_matched(const ui::Theme& theme, const ui::Rect& in, const std::string& name,
                    const Ranked& ranked, ui::Color color)
{
    const ImFont* font = theme.font.body;
    float x = in.lo.x;
    for (std::size_t i = 0; i < name.size();) {
        const auto matched = [&](std::size_t at) {
            return std::ranges::binary_search(ranked.letters, at);
        };
        std::size_t end = i + 1;
        while (end < name.size() && matched(end) == matched(i)) ++end;
        const std::string part = name.substr(i, end - i);
        ui::paint_text(font, {{x, in.lo.y}, in.hi}, matched(i) ? theme.color.accent_text : color,
                       part);
        x += ui::text_width(font, part);
        i = end;
    }
    return x;
}

float caps_width(const ui::Theme& theme, const std::vector<std::string>& caps)
{
    float width = 0;
    for (const std::string& cap : caps) width += ui::keycap_width(theme, cap) + theme.px(4);
    return width;
}

void paint_entry(const ui::Theme& theme, const ui::Rect& row, const PaletteEntry& entry,
                 const Ranked& ranked, bool chosen)
{
    const ui::Palette& c = theme.color;
    const bool can = entry.why_not.empty();
    if (chosen)
        ui::paint_box({row.lo + glm::vec2(theme.px(8), 0), row.hi - glm::vec2(theme.px(8), 0)},
                      c.row_selected, theme.size.rounding);
    const float caps = caps_width(theme, entry.key_caps);
    const ui::Color quiet = chosen ? c.text_2 : c.text_3;
    ui::paint_text(theme.font.body, {row.lo + glm::vec2(theme.px(20), 0), row.hi}, quiet,
                   entry.icon);
    const float left = row.lo.x + theme.px(52), right = row.hi.x - theme.px(20) - caps;
    const std::string name = ui::elided(theme.font.body, entry.name, right - left);
    if (name != entry.name) ui::tooltip(theme, entry.name);
    const float end = paint_matched(theme, {{left, row.lo.y}, {right, row.hi.y}}, name, ranked,
                                    can ? c.text : quiet);
    const float room = right - theme.px(12) - end - theme.px(12);
    if (room > theme.px(40))
        ui::paint_text(theme.font.small, {{end + theme.px(12), row.lo.y}, row.hi}, quiet,
                       ui::elided(theme.font.small, can ? entry.note : entry.why_not, room));
    float x = row.hi.x - theme.px(20) - caps + theme.px(4);
    for (const std::string& cap : entry.key_caps)
        x += ui::paint_keycap(theme, {x, row.lo.y}, row.height(), cap) + theme.px(4);
}

// What is typed, in large letters, and how much is found.
void draw_field(CommandPalette& palette, const ui::Theme& theme, const ui::Rect& r,
                const std::string& count)
{
    const ui::Palette& c = theme.color;
    const float words = ui::text_width(theme.font.small, count);
    ui::paint_text(theme.font.title, {r.lo + glm::vec2(theme.px(20), 0), r.hi}, c.text_2,
                   ui::icon::search);
    ui::paint_text(theme.font.small, {r.lo, r.hi - glm::vec2(theme.px(20), 0)}, c.text_3, count,
                   ui::Align::right);
    const float left = r.lo.x + theme.px(52), line = theme.px(24);
    const ui::Rect field = {{left, std::round(r.center().y - line / 2)},
                            {r.hi.x - theme.px(32) - words, r.center().y + line / 2}};
    ImGui::SetCursorScreenPos({field.lo.x, field.lo.y});
    ImGui::PushFont(theme.font.title);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, theme.px(2)});
    ImGui::SetNextItemWidth(field.width());
    if (std::exchange(palette.fresh, false)) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputText("##letters", &palette.typed)) palette.chosen = 0;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (palette.typed.empty())
        ui::paint_text(theme.font.body, {{left + theme.px(4), r.lo.y}, {field.hi.x, r.hi.y}},
                       c.text_3, "Search commands, > objects, : preferences");
    ui::paint_box({{r.lo.x, r.hi.y}, {r.hi.x, r.hi.y + theme.size.hairline}}, c.line_soft);
}

struct List {
    std::vector<PaletteEntry> entries;
    std::vector<Ranked> found;
    bool objects = false, preferences = false;
    bool commands() const { return !objects && !preferences; }
    const char* what() const
    {
        return objects ? "objects" : preferences ? "preferences" : "commands";
    }
};
List list_of(const Editor& editor)
{
    const std::string& typed = editor.palette.typed;
    List list;
    list.objects = typed.starts_with('>');
    list.preferences = typed.starts_with(':');
    list.entries = list.objects       ? palette_objects(editor)
                   : list.preferences ? palette_preferences(editor)
                                      : palette_commands(editor);
    const std::string_view letters = std::string_view(typed).substr(list.commands() ? 0 : 1);
    std::vector<std::string> names, notes;
    for (const PaletteEntry& each : list.entries) {
        names.push_back(each.name);
        notes.push_back(each.note);
    }
    const std::vector<std::string> none;
    list.found =
        ranked(letters, names, list.commands() ? editor.preferences.recent_commands : none);
    if (!list.found.empty()) return list;
    list.found = ranked(letters, notes, none); // by its menu or by what it is for
    for (Ranked& each : list.found) each.letters.clear();
    return list;
}

void draw_hints(const ui::Theme& theme, const ui::Rect& r, const List& list)
{
    const ui::Palette& c = theme.color;
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line_soft);
    float x = r.lo.x + theme.px(20);
    const auto hint = [&](std::initializer_list<const char*> caps, const std::string& verb) {
        for (const char* cap : caps)
            x += ui::paint_keycap(theme, {x, r.lo.y}, r.height(), cap) + theme.px(4);
        x += theme.px(4);
        ui::paint_text(theme.font.small, {{x, r.lo.y}, r.hi}, c.text_2, verb);
        x += ui::text_width(theme.font.small, verb) + theme.px(14);
    };
    hint({"Enter"}, list.objects ? "Select" : list.preferences ? "Change" : "Run");
    hint({"Up", "Down"}, "Choose");
    if (list.commands()) hint({"Alt", "Enter"}, "Change its key");
    if (list.commands()) hint({">"}, "Objects");
    if (list.commands()) hint({":"}, "Preferences");
    hint({"Esc"}, "Close");
}

// The rows with their captions; the index in `found` that was clicked.
std::optional<std::size_t> draw_list(CommandPalette& palette, const ui::Theme& theme,
                                     const ui::Rect& r, const List& list, bool chosen_by_key)
{
    const ui::Palette& c = theme.color;
    const float row = theme.px(36), caption = theme.px(28);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::BeginChild("list", {r.width(), r.height()});
    const ImVec2 top = ImGui::GetCursorScreenPos();
    std::optional<std::size_t> clicked;
    float y = top.y;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    for (std::size_t i = 0; i < list.found.size(); ++i) {
        const bool first = i == 0, others = i > 0 && list.found[i - 1].recent;
        if (first || (others && !list.found[i].recent)) {
            const char* words = list.objects           ? "OBJECTS"
                                : list.preferences     ? "PREFERENCES"
                                : list.found[i].recent ? "RECENT"
                                                       : "COMMANDS";
            ui::paint_text(theme.font.small_strong,
                           {{r.lo.x + theme.px(20), y}, {r.hi.x, y + caption}}, c.text_3, words);
            y += caption;
        }
        const ui::Rect at = {{r.lo.x, y}, {r.hi.x, y + row}};
        y += row;
        if (i == palette.chosen && chosen_by_key) {
            if (at.lo.y < r.lo.y) ImGui::SetScrollY(ImGui::GetScrollY() + at.lo.y - r.lo.y);
            if (at.hi.y > r.hi.y) ImGui::SetScrollY(ImGui::GetScrollY() + at.hi.y - r.hi.y);
        }
        if (at.hi.y < r.lo.y || at.lo.y > r.hi.y) continue; // scrolled away
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
        if (ImGui::InvisibleButton("entry", {at.width(), at.height()})) clicked = i;
        if (ImGui::IsItemHovered() && (moved.x != 0 || moved.y != 0)) palette.chosen = i;
        ImGui::PopID();
        paint_entry(theme, at, list.entries[list.found[i].index], list.found[i],
                    i == palette.chosen);
    }
    ImGui::SetCursorScreenPos(top);
    ImGui::Dummy({1, y - top.y + theme.px(8)});
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return clicked;
}

} // namespace

void draw_command_palette(Editor& editor, const ui::Theme& theme)
{
    CommandPalette& palette = editor.palette;
    if (!palette.open) return;
    const bool fresh = palette.fresh; // the key that opened it is still struck
    const float head = theme.px(56), foot = theme.px(40);
    const float top = std::min(theme.px(120), ImGui::GetIO().DisplaySize.y * 0.14f);
    const ui::Rect r = ui::begin_dialog(theme, "command palette", {theme.px(640), theme.px(480)},
                                        {.from_top = top, .scrim = 0.55f});
    List list = list_of(editor);
    const std::size_t count = list.found.size();
    draw_field(palette, theme, {r.lo, {r.hi.x, r.lo.y + head}},
               fmt::format("{} of {} {}", count, list.entries.size(), list.what()));
    list = list_of(editor); // by what was typed in this frame
    const bool down = ImGui::IsKeyPressed(ui::key_down), up = ImGui::IsKeyPressed(ui::key_up);
    const std::size_t found = list.found.size();
    palette.chosen = found == 0 ? 0 : std::min(palette.chosen, found - 1);
    if (down && palette.chosen + 1 < found) ++palette.chosen;
    if (up && palette.chosen > 0) --palette.chosen;
    const ui::Rect rows = {{r.lo.x, r.lo.y + head + theme.px(4)}, {r.hi.x, r.hi.y - foot}};
    const auto entry_at = [&](std::size_t i) { return &list.entries[list.found[i].index]; };
    const PaletteEntry* picked = nullptr;
    if (found == 0)
        ui::empty_state(theme, rows, ui::icon::search,
                        list.objects       ? "No object is called that"
                        : list.preferences ? "No preference is called that"
                                           : "No command is called that",
                        list.commands() ? "Take letters away, or begin with > to find an object."
                                        : "Take letters away to see more of them.");
    else if (const auto clicked = draw_list(palette, theme, rows, list, down || up))
        picked = entry_at(*clicked);
    draw_hints(theme, {{r.lo.x, r.hi.y - foot}, r.hi}, list);
    const bool enter = ImGui::IsKeyPressed(ui::key_enter, false) ||
                       ImGui::IsKeyPressed(ui::key_keypad_enter, false);
    if (enter && found > 0) picked = entry_at(palette.chosen);
    const bool key_wanted = enter && ImGui::GetIO().KeyAlt;
    if (picked && (key_wanted ? picked->action.empty() : !picked->why_not.empty()))
        picked = nullptr;
    // A click beside it closes it, as does the key that opened it.
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool beside =
        ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !r.contains({mouse.x, mouse.y});
    const bool again =
        !fresh && std::ranges::any_of(action(editor, palette_action).keys, ui::struck_while_typing);
    palette.open = !picked && !beside && !again && !ImGui::IsKeyPressed(ui::key_escape, false);
    if (!palette.open) ImGui::CloseCurrentPopup();
    ui::end_dialog();
    if (!picked) return;
    if (key_wanted) return ask_for_key(editor, picked->action);
    if (list.commands()) remember(editor.preferences.recent_commands, picked->name);
    picked->run(editor);
}

} // namespace trivar
