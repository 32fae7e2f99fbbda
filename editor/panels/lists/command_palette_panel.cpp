// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/command_filling.h"
#include "editor/actions/palette_entries.h"
#include "editor/actions/palette_search.h"
#include "editor/actions/use_keys.h"
#include "editor/panels/lists/palette_rows.h"
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

// Draws the typed text in large letters, and the number of entries found.
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
    // Tab would go to another field: here it is taken, and does what the list does with it.
    const auto take_tab = [](ImGuiInputTextCallbackData*) { return 0; };
    if (ImGui::InputText("##letters", &palette.typed, ImGuiInputTextFlags_CallbackCompletion,
                         take_tab))
        palette.chosen = 0;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (palette.typed.empty())
        ui::paint_text(theme.font.body, {{left + theme.px(4), r.lo.y}, {field.hi.x, r.hi.y}},
                       c.text_3, "Search commands, > objects, : preferences");
    ui::paint_box({{r.lo.x, r.hi.y}, {r.hi.x, r.hi.y + theme.size.hairline}}, c.line_soft);
}

struct List : PaletteRows {
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
    list.caption = list.objects ? "OBJECTS" : list.preferences ? "PREFERENCES" : "COMMANDS";
    const std::string_view letters = std::string_view(typed).substr(list.commands() ? 0 : 1);
    const std::vector<std::string> none;
    list.found = found_entries(letters, list.entries,
                               list.commands() ? editor.preferences.recent_commands : none);
    return list;
}

std::vector<PaletteHint> hints_of(const List& list, const PaletteEntry* chosen)
{
    const bool values = chosen && chosen->fill;
    const bool first = values && chosen->needs_values;
    std::vector<PaletteHint> hints{{{"Enter"},
                                    list.objects       ? "Select"
                                    : list.preferences ? "Change"
                                    : first            ? "Values"
                                                       : "Run"}};
    if (values && !first) hints.push_back({{"Tab"}, "Values"});
    hints.push_back({{"Up", "Down"}, "Choose"});
    if (list.commands() && (!chosen || !chosen->action.empty()))
        hints.push_back({{"Alt", "Enter"}, "Change its key"});
    if (list.commands()) hints.push_back({{">"}, "Objects"});
    if (list.commands()) hints.push_back({{":"}, "Preferences"});
    hints.push_back({{"Esc"}, "Close"});
    return hints;
}

} // namespace

void draw_command_palette(Editor& editor, const ui::Theme& theme)
{
    CommandPalette& palette = editor.palette;
    if (!palette.open) return;
    if (palette.filling) return draw_filling(editor, theme);
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
    std::optional<std::size_t> chosen = palette.chosen;
    if (found > 0)
        if (const auto clicked = draw_rows(theme, rows, list, chosen, down || up))
            picked = entry_at(*clicked);
    palette.chosen = chosen.value_or(0);
    draw_palette_hints(theme, {{r.lo.x, r.hi.y - foot}, r.hi},
                       hints_of(list, found > 0 ? entry_at(palette.chosen) : nullptr));
    const bool enter = ImGui::IsKeyPressed(ui::key_enter, false) ||
                       ImGui::IsKeyPressed(ui::key_keypad_enter, false);
    const bool tab = ImGui::IsKeyPressed(ui::key_tab, false);
    if ((enter || tab) && found > 0) picked = entry_at(palette.chosen);
    const bool key_wanted = enter && ImGui::GetIO().KeyAlt;
    const bool values_wanted = picked && picked->fill && (tab || picked->needs_values);
    if (tab && !values_wanted) picked = nullptr;
    if (picked && (key_wanted ? picked->action.empty() : !tab && !picked->why_not.empty()))
        picked = nullptr;
    if (picked && values_wanted && !key_wanted)
        if (auto form = form_of(*picked->fill, picked->name, editor.session.committed())) {
            ui::end_dialog();
            remember(editor.preferences.recent_commands, picked->name);
            begin_filling(editor, std::move(*form));
            return;
        }
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
