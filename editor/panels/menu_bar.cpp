// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/menu_bar.h"

#include "core/commands/objects/view.h"
#include "editor/actions/menu_letters.h"
#include "editor/actions/menus_beside.h"
#include "editor/panels/panels.h"
#include "editor/session/recent_scenes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

const std::vector<std::string>& menu_names()
{
    static const std::vector<std::string> names{"File", "Edit",    "Select", "Add",
                                                "View", "Animate", "Tools",  "Help"};
    return names;
}

// The letters that do something else when Alt is held.
std::string taken_with_alt(const Editor& editor)
{
    std::string letters;
    for (const Action& each : editor.actions)
        for (const ui::Chord& key : each.keys)
            if (key.alt && !key.ctrl && !key.shift && key.key >= 'A' && key.key <= 'Z')
                letters += static_cast<char>(key.key);
    return letters;
}

// Below a letter of a name that is written at a place.
void underline(ImDrawList& list, const ui::Theme& theme, const ImVec2& at, const std::string& name,
               char key)
{
    const auto found = std::ranges::find_if(
        name, [&](char c) { return std::toupper(static_cast<unsigned char>(c)) == key; });
    if (key == 0 || found == name.end()) return;
    const auto before = static_cast<std::size_t>(found - name.begin());
    const float x = at.x + ui::text_width(theme.font.body, name.substr(0, before));
    const float wide = ui::text_width(theme.font.body, name.substr(before, 1));
    const float y = std::round(at.y + theme.px(15));
    list.AddRectFilled({x, y}, {x + wide, y + theme.size.hairline}, theme.color.text_2);
}

void kept_views(Editor& editor)
{
    if (editor.session.document().kept_views.empty()) return;
    ImGui::Separator();
    std::string forget;
    for (const auto& [name, camera] : editor.session.document().kept_views) {
        if (!ImGui::BeginMenu(name.c_str())) continue;
        if (ImGui::MenuItem("Go there")) editor.session.view.follows = FollowedView{name};
        if (ImGui::MenuItem("Forget")) forget = name;
        ImGui::EndMenu();
    }
    if (!forget.empty()) editor.session.run(ForgetView{forget});
}

void recent_scenes(Editor& editor)
{
    const auto& recent = editor.memory.of<RecentScenes>().of(editor.preferences.recent_scenes);
    if (recent.empty() || !ImGui::BeginMenu("Open recent")) return;
    for (std::size_t i = 0; i < recent.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::MenuItem(recent[i].name.c_str(), recent[i].folder.c_str(), false,
                            recent[i].there))
            editor.files.open_scene(std::string(recent[i].path));
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void menu_items(Editor& editor, const ui::Theme& theme, const std::string& menu);

void menu_beside(Editor& editor, const ui::Theme& theme, const char* menu)
{
    if (std::ranges::find(editor.actions, menu, &Action::menu) == editor.actions.end()) return;
    if (!ImGui::BeginMenu(menu)) return;
    menu_items(editor, theme, menu);
    ImGui::EndMenu();
}

// The actions of the menu that is open; the letter of one, pressed, runs it.
void menu_items(Editor& editor, const ui::Theme& theme, const std::string& menu)
{
    std::vector<std::size_t> items;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < editor.actions.size(); ++i)
        if (editor.actions[i].menu == menu) {
            items.push_back(i);
            names.push_back(editor.actions[i].name);
        }
    const std::vector<char> letters = menu_letters(names);
    // The one that is open and has none open beside it. What opened it is no letter of its own.
    const ImGuiContext& g = *GImGui;
    const bool listens =
        g.OpenPopupStack.Size == g.BeginPopupStack.Size && !ImGui::IsWindowAppearing();
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Action& each = editor.actions[items[i]];
        if (each.group_begins) ImGui::Separator();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        menu_item(editor, each);
        if (editor.memory.of<MenuBar>().by_letter)
            underline(*ImGui::GetWindowDrawList(), theme, at, names[i], letters[i]);
        const bool pressed = letters[i] && ui::struck({letters[i]});
        if (listens && pressed && is_enabled(editor, each)) chosen = items[i];
        if (each.name == "Open...") recent_scenes(editor);
        for (const MenuBeside& beside : menus_beside)
            if (each.name == beside.after) menu_beside(editor, theme, beside.name);
    }
    if (!chosen) return;
    ImGui::ClosePopupToLevel(0, true);
    editor.actions[*chosen].run(editor);
}

// Left and right go from menu to menu, unless they open or close one beside it.
void go_to_neighbour(Editor& editor, std::size_t menu)
{
    const ImGuiContext& g = *GImGui;
    const bool right = ImGui::IsKeyPressed(ui::key_right, false);
    if (!right && !ImGui::IsKeyPressed(ui::key_left, false)) return;
    if (g.OpenPopupStack.Size != g.BeginPopupStack.Size || editor.memory.of<MenuBar>().beside)
        return;
    const std::size_t count = menu_names().size();
    editor.memory.of<MenuBar>().next = menu_names()[(menu + (right ? 1 : count - 1)) % count];
    ImGui::NavMoveRequestCancel();
}

// The menu whose letter was pressed with Alt, where a menu may open now.
std::string asked_menu(const Editor& editor, const std::vector<char>& letters)
{
    if (editor.active_tool().busy() || editor.files.asking()) return {};
    const bool other =
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (other && editor.memory.of<MenuBar>().open.empty()) return {};
    for (std::size_t i = 0; i < letters.size(); ++i)
        if (letters[i] && ui::struck({.key = letters[i], .alt = true})) return menu_names()[i];
    return {};
}

// Pixels at scale 1, where there is room: before the first name, and half of what is between two.
constexpr float menus_begin_px = 18, half_between_px = 10;

// `below`: where the bar ends; `between`: half of what is between two names.
void menus(Editor& editor, const ui::Theme& theme, float below, float between)
{
    const std::vector<std::string>& names = menu_names();
    const std::vector<char> letters = menu_letters(names, taken_with_alt(editor));
    auto& bar = editor.memory.of<MenuBar>();
    std::string asked = asked_menu(editor, letters);
    if (!asked.empty()) bar.by_letter = true;
    if (asked.empty()) asked = bar.next;
    bar.next.clear();
    std::string open;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& menu = names[i];
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(8), theme.px(8)});
        ImVec2 at = ImGui::GetCursorScreenPos();
        at.x += std::floor(ImGui::GetStyle().ItemSpacing.x / 2);
        at.y += theme.px(12);
        if (ImGui::GetIO().KeyAlt)
            underline(*ImGui::GetForegroundDrawList(), theme, at, menu, letters[i]);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {between, theme.px(8)});
        // One that is higher than the window scrolls: over its own title a click would run an item.
        const float room = ImGui::GetIO().DisplaySize.y - below - theme.px(4);
        ImGui::SetNextWindowSizeConstraints({theme.px(216), 0}, {1e6f, room});
        if (menu == asked) ImGui::OpenPopup(menu.c_str());
        if (ImGui::BeginMenu(menu.c_str())) {
            open = menu;
            menu_items(editor, theme, menu);
            if (menu == "View") kept_views(editor);
            if (menu == "Add") draw_model_menu(editor, theme);
            if (menu == "Help")
                for (const char* each : {"Samples", "Tutorials"}) menu_beside(editor, theme, each);
            go_to_neighbour(editor, i);
            bar.beside = GImGui->OpenPopupStack.Size > GImGui->BeginPopupStack.Size;
            ImGui::EndMenu();
        }
        ImGui::PopStyleVar(2);
    }
    if (open.empty() && asked.empty()) bar.by_letter = false;
    bar.open = open;
}

} // namespace

void menu_item(Editor& editor, const Action& each)
{
    const bool on = each.on && each.on(editor);
    if (ImGui::MenuItem(each.name.c_str(), key_text(each).c_str(), on, is_enabled(editor, each)))
        each.run(editor);
}

MenuBarWidths menu_bar_widths(const ui::Theme& theme)
{
    MenuBarWidths out{0, theme.px(menus_begin_px)};
    for (const std::string& each : menu_names()) {
        out.names += ui::text_width(theme.font.body, each);
        out.between += 2 * theme.px(half_between_px);
    }
    return out;
}

float draw_menu_bar(Editor& editor, const ui::Theme& theme, const ui::Rect& bar, float spread)
{
    ImGui::SetCursorScreenPos({bar.lo.x + theme.px(menus_left_px), bar.lo.y});
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.px(8), theme.px(12)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {std::floor(spread * theme.px(menus_begin_px)), 0});
    ImGui::PushStyleColor(ImGuiCol_MenuBarBg, 0);
    // ImGui keeps a menu bar inside a window of its own kind; a child gives it one.
    const MenuBarWidths widths = menu_bar_widths(theme);
    const float width = widths.names + spread * widths.between;
    ImGui::BeginChild("menus", {std::ceil(width), bar.height()}, false,
                      ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar);
    float end = 0;
    if (ImGui::BeginMenuBar()) {
        menus(editor, theme, bar.hi.y, std::floor(spread * theme.px(half_between_px)));
        end = ImGui::GetCursorScreenPos().x;
        ImGui::EndMenuBar();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    ImGui::EndGroup();
    return end;
}

} // namespace trivar
