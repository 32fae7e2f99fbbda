// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include "editor/actions/lattice_actions.h"
#include "editor/actions/left_behind.h"
#include "editor/actions/placement_actions.h"
#include "editor/session/scene_facts.h"

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
                                                 rule,
                                                 "Cut",
                                                 "Copy",
                                                 "Paste",
                                                 "Duplicate",
                                                 rule,
                                                 "Group",
                                                 "Ungroup",
                                                 "Parent",
                                                 "Clear parent",
                                                 "Attach",
                                                 "Detach",
                                                 "Remove from stroke",
                                                 rule,
                                                 "Hide or show",
                                                 "Hide others",
                                                 "Lock or unlock",
                                                 rule,
                                                 "Delete"};
// Where they can be done.
const std::vector<std::string_view> with_lattices{add_to_lattice_action, take_out_of_lattice_action,
                                                  back_to_rest_action, keep_shape_action};
const std::vector<std::string_view> with_laid{plain_copy_action, apply_shape_action};
const std::vector<std::string_view> with_surfaces{"Shade smooth", "Shade by angle", "Shade flat"};
const std::vector<std::string_view> with_nothing{
    "Frame all", "Select all", "Show all", rule, "Paste", add_action_name, "Import model..."};

// A MenuStyle sets the spacing of menus as long as it lives.
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

// A letter runs the one entry that begins with it.
void take_letter(Editor& editor, const std::vector<const Action*>& entries)
{
    if (ImGui::IsWindowAppearing() || ImGui::GetIO().InputQueueCharacters.empty()) return;
    const ImWchar typed = ImGui::GetIO().InputQueueCharacters.front();
    const Action* found = nullptr;
    for (const Action* each : entries) {
        const auto first = static_cast<ImWchar>(each->name.front());
        if (first != typed && first != typed - 'a' + 'A') continue;
        if (found) return;
        found = each;
    }
    if (!found || !is_enabled(editor, *found)) return;
    ImGui::CloseCurrentPopup();
    found->run(editor);
}

} // namespace

void draw_object_menu(Editor& editor, const ui::Theme& theme, const char* name)
{
    const MenuStyle style(theme);
    if (ImGui::BeginPopup(name)) {
        std::vector<const Action*> entries;
        for (const std::string_view entry :
             editor.session.selected == 0 ? with_nothing : with_objects) {
            if (entry == rule) {
                ImGui::Separator();
                continue;
            }
            entries.push_back(&action(editor, std::string(entry)));
            menu_item(editor, *entries.back());
        }
        for (const auto& some : {with_lattices, with_laid, with_surfaces}) {
            bool first = true;
            for (const std::string_view entry : some) {
                const Action& each = action(editor, std::string(entry));
                if (!is_enabled(editor, each)) continue;
                if (std::exchange(first, false)) ImGui::Separator();
                entries.push_back(&each);
                menu_item(editor, each);
            }
        }
        take_letter(editor, entries);
        ImGui::EndPopup();
    }
}

void draw_add_menu(Editor& editor, const ui::Theme& theme)
{
    const MenuStyle style(theme);
    if (std::exchange(editor.add_menu_asked, false)) ImGui::OpenPopup("add menu");
    if (!ImGui::BeginPopup("add menu")) return;
    std::vector<const Action*> entries;
    for (const Action& each : editor.actions)
        if (each.menu == "Add" && each.name != add_action_name) entries.push_back(&each);
    for (const Action* each : entries) menu_item(editor, *each);
    draw_model_menu(editor, theme);
    ImGui::Separator();
    entries.push_back(&action(editor, "Import model..."));
    menu_item(editor, *entries.back());
    take_letter(editor, entries);
    ImGui::EndPopup();
}

void draw_bind_menu(Editor& editor, const ui::Theme& theme)
{
    const MenuStyle style(theme);
    auto& asked = editor.memory.of<BindChoice>();
    if (std::exchange(asked.asked, false)) ImGui::OpenPopup("bind menu");
    if (!ImGui::BeginPopup("bind menu")) return;
    const BindChoice choice = asked; // the step may make another
    const std::vector<Id> others = can_be_bound_to(editor, choice.dependents);
    if (others.empty()) ImGui::MenuItem("There is no other object", nullptr, false, false);
    for (const Id id : others) {
        ImGui::PushID(id);
        if (ImGui::MenuItem(name_of(editor.session.committed(), id).c_str()))
            bind_to(editor, choice, id);
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

} // namespace trivar
