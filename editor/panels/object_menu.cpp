// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include <imgui.h>
#include <string_view>
#include <utility>
#include <vector>

namespace trivar {
namespace {

// A rule above it.
constexpr std::string_view rule = "-";

const std::vector<std::string_view> with_objects{"Frame selection",
                                                 "Rename",
                                                 "Duplicate",
                                                 "Group",
                                                 "Ungroup",
                                                 "Take off the stroke",
                                                 rule,
                                                 "Hide or show",
                                                 "Hide the others",
                                                 "Lock or unlock",
                                                 rule,
                                                 "Delete"};
const std::vector<std::string_view> with_nothing{"Frame all", "Select all",    "Show all",
                                                 rule,        add_action_name, "Import model..."};

// How menus are spaced, as long as it lives.
struct MenuStyle {
    explicit MenuStyle(const ui::Theme& theme)
    {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(8), theme.px(8)});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(10), theme.px(8)});
        ImGui::SetNextWindowSizeConstraints({theme.px(216), 0}, {1e6f, 1e6f});
    }
    ~MenuStyle() { ImGui::PopStyleVar(2); }
    MenuStyle(const MenuStyle&) = delete;
    MenuStyle& operator=(const MenuStyle&) = delete;
};

} // namespace

void draw_object_menu(Editor& editor, const ui::Theme& theme, const char* name)
{
    const MenuStyle style(theme);
    if (ImGui::BeginPopup(name)) {
        for (const std::string_view entry :
             editor.session.selected == 0 ? with_nothing : with_objects) {
            if (entry == rule) {
                ImGui::Separator();
                continue;
            }
            menu_item(editor, action(editor, std::string(entry)));
        }
        ImGui::EndPopup();
    }
}

void draw_add_menu(Editor& editor, const ui::Theme& theme)
{
    const MenuStyle style(theme);
    if (std::exchange(editor.add_menu_asked, false)) ImGui::OpenPopup("add menu");
    if (!ImGui::BeginPopup("add menu")) return;
    for (std::size_t i = 0; i < editor.actions.size(); ++i)
        if (editor.actions[i].menu == "Add" && editor.actions[i].name != add_action_name)
            menu_item(editor, editor.actions[i]);
    ImGui::Separator();
    menu_item(editor, action(editor, "Import model..."));
    ImGui::EndPopup();
}

} // namespace trivar
