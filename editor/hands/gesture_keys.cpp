// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gesture_keys.h"

#include "editor/session/topics.h"
#include "ui/keys.h"

#include <imgui.h>

namespace trivar {
namespace {

// Whatever is held beside it: Ctrl and Shift say how the hand moves.
bool struck_anyhow(int key)
{
    return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key, false);
}

} // namespace

bool take_gesture_keys(TransformGesture& gesture, bool begun_by_key, bool outside)
{
    TypedAmounts& typed = gesture.typed();
    const bool writes = typed.text(typed.at()).starts_with('=');
    for (int axis = 0; axis < 3 && !writes; ++axis)
        if (struck_anyhow('X' + axis)) gesture.choose_axis(axis, ImGui::GetIO().KeyShift);
    typed.take_letters();
    if (struck_anyhow(ui::key_tab)) typed.next(gesture.numbers());
    const bool elsewhere = begun_by_key && outside && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    return elsewhere || struck_anyhow(ui::key_enter) || struck_anyhow(ui::key_keypad_enter);
}

void say_no_point_is_selected(Session& session)
{
    session.notices.say(ui::NoticeKind::warning, "No control point is selected",
                        "Click one, or drag a box over some. With the Select tool the keys move, "
                        "turn and scale the whole object.",
                        of_a_step);
}

} // namespace trivar
