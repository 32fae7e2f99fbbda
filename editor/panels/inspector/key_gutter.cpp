// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/key_gutter.h"

#include "editor/actions/key_actions.h"
#include "editor/panels/inspector/field_cells.h"
#include "editor/panels/inspector/inspect.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {

std::vector<std::string> axes_of(const std::string& parameter, int count)
{
    std::vector<std::string> out;
    for (int axis = 0; axis < count; ++axis) out.push_back(parameter + "." + "xyzw"[axis]);
    return out;
}

void KeyGutter::menu(const KeyTarget& all, const std::string& shown) const
{
    if (!ImGui::BeginPopup("key menu")) return;
    Session& session = editor_.session;
    const KeyState state = state_of_keys(session, all);
    const auto item = [&](const char* words, const std::string& key, bool enabled) {
        return ImGui::MenuItem(words, key.empty() ? nullptr : key.c_str(), false, enabled);
    };
    if (item("Insert key", key_text(action(editor_, insert_key_action)), true))
        insert_keys(session, all);
    if (item("Remove key", key_text(action(editor_, remove_key_action)),
             state != KeyState::none &&
                 without_keys(session.document(), all.ids, all.names, session.frame())))
        remove_keys(session, all);
    if (item("Remove all keys", {}, state != KeyState::none)) remove_tracks(session, all);
    ImGui::Separator();
    if (item("Show in the timeline", {}, state != KeyState::none)) show_tracks(editor_, all);
    if (item("Copy keys as command", {}, state != KeyState::none))
        if (const auto command = tracks_command(session.document(), all))
            copy_command(editor_, *command);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopStyleColor();
    ImGui::EndPopup();
}

void KeyGutter::mark(const ui::Theme& theme, const ui::Row& row,
                     const std::vector<std::string>& names, bool apart) const
{
    const ui::Palette& c = theme.color;
    const ImVec2 field = ImGui::GetCursorScreenPos();
    const KeyTarget all{ids_, names};
    const ui::Rect place =
        ui::rect_at({field.x + row.width, field.y}, {theme.px(16), theme.size.row});
    ImGui::PushID((names.front() + " " + std::to_string(names.size())).c_str());
    ImGui::SetCursorScreenPos({place.lo.x, place.lo.y});
    if (ImGui::InvisibleButton("key", {place.width(), place.height()}))
        toggle_keys(editor_.session, all);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("key menu");
    const bool hot = ImGui::IsItemHovered();
    const KeyState state = state_of_keys(editor_.session, all);
    ui::tooltip(
        {state == KeyState::here ? "Remove this key" : "Insert a key",
         key_text(action(editor_, state == KeyState::here ? remove_key_action : insert_key_action)),
         state == KeyState::none
             ? "A key for the value in this frame. Values between keys are interpolated."
             : "Has keys, shown in the timeline."});
    menu(all, names.size() == 1 ? names.front() : names.front() + " ...");
    const ui::Color rim = state != KeyState::none ? c.key : hot ? c.text : c.text_3;
    ui::paint_diamond(place.center(), theme.px(hot ? 5 : 4) + 0.5f,
                      state == KeyState::here ? c.key : 0, rim, theme.size.hairline);
    ImGui::PopID();
    const FieldCells cells(theme, row.width, apart ? static_cast<int>(names.size()) : 1);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float window = ImGui::GetWindowPos().x;
    KeyTarget under = all;
    ui::Rect whole{{window, place.lo.y}, place.hi};
    for (std::size_t i = 0; apart && i < names.size(); ++i) {
        const glm::vec2 at = glm::vec2(field.x, field.y) + cells.offset(static_cast<int>(i));
        const ui::Rect cell = ui::rect_at(at, {cells.width, theme.size.row});
        const KeyTarget one{ids_, {names[i]}};
        if (cell.contains({mouse.x, mouse.y})) under = one;
        whole.hi.y = std::max(whole.hi.y, cell.hi.y);
        if (state != KeyState::none && state_of_keys(editor_.session, one) != KeyState::none)
            ui::paint_box(ui::rect_at({at.x, cell.hi.y + theme.px(1)}, {cells.width, theme.px(2)}),
                          c.key, theme.px(1));
    }
    if (!ui::is_greyed() &&
        ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
        ImGui::IsMouseHoveringRect({whole.lo.x, whole.lo.y}, {whole.hi.x, whole.hi.y}))
        editor_.keys_under_mouse = under;
    ImGui::SetCursorScreenPos(field);
}

} // namespace trivar
