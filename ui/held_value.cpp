// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/held_value.h"

#include "ui/input.h"
#include "ui/keys.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {

Edit after_drag(Edit edit, bool held)
{
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID twice = ImGui::GetID("twice");
    const bool active = ImGui::IsItemActive();
    if (active && held) hands().may_hold_on();
    if (ImGui::IsItemActivated())
        kept.SetBool(twice, held && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
    else if (edit != Edit::none)
        kept.SetBool(twice, false);
    else if (ImGui::IsItemDeactivated() && kept.GetBool(twice))
        type_next_number();
    if (!active || !ImGui::IsKeyPressed(key_escape, false)) return edit;
    ImGui::ClearActiveID();
    return Edit::cancelled;
}

} // namespace trivar::ui
