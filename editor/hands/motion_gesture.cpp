// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/motion_gesture.h"

#include "core/commands/edits/edits.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"
#include "ui/keys.h"

#include <imgui.h>

namespace trivar {

void MotionGesture::begin(MotionKind kind, Id object, const MotionFrame& stands,
                          const GizmoHandle& handle, const Camera& camera,
                          const ViewportInput& input)
{
    const Stand stand{object,
                      {.translation = stands.pivot,
                       .rotation_deg = decomposed(glm::dmat4(stands.axes)).rotation_deg},
                      glm::dmat4(1)};
    begin(TransformGesture(kind, {stand}, object,
                           {.orientation = Orientation::local, .step_m = 0.01}, camera,
                           {stands.pivot, handle, input.mouse, input.scale}),
          input, handle.grip == Grip::none);
}

bool MotionGesture::meant() const
{
    return by_key() || (*this)->travelled_px() >= click_slip_px || (*this)->typed().open();
}

Gesture::Wanted MotionGesture::more_than_nothing(const Wanted& wanted) const
{
    return [this, &wanted] {
        return meant() && !(*this)->motion().is_nothing() ? wanted() : std::nullopt;
    };
}

Gesture::State MotionGesture::go_on(Session& session, const ViewportInput& input,
                                    const Wanted& wanted, const Commit& commit)
{
    const ImGuiIO& io = ImGui::GetIO();
    (*this)->move_hand(session.view.camera, input.mouse, {.snap = io.KeyCtrl, .fine = io.KeyShift});
    return Gesture::go_on(session, input, more_than_nothing(wanted), commit);
}

Gesture::State MotionGesture::finish(Session& session, const Wanted& wanted, const Commit& commit)
{
    return Gesture::finish(session, more_than_nothing(wanted), commit);
}

bool MotionGesture::take_keys()
{
    const auto struck = [](int key) {
        return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key, false);
    };
    TransformGesture& motion = **this;
    const bool formula = types_formula();
    for (int axis = 0; axis < 3 && !formula; ++axis)
        if (struck('X' + axis)) motion.choose_axis(axis, ImGui::GetIO().KeyShift);
    motion.typed().take_letters();
    if (struck(ui::key_tab)) motion.typed().next(motion.numbers());
    return Gesture::take_keys();
}

bool MotionGesture::types_formula() const
{
    const TypedAmounts& typed = (*this)->typed();
    return typed.text(typed.at()).starts_with('=');
}

std::vector<Hint> MotionGesture::hints(const char* axes) const
{
    return {{{}, (*this)->words()},
            {{"left"}, by_key() ? "Done" : "Let go when done"},
            {{"X", "Y", "Z"}, axes},
            {{"0", "-", "9"}, "Type it"},
            {{"Ctrl"}, "Snap"},
            {{"Shift"}, "Fine"},
            {{"Esc", "/", "right"}, "Cancel"}};
}

void say_no_point_is_selected(Session& session)
{
    session.notices.say(ui::NoticeKind::warning, "No control point is selected",
                        "Click one, or drag a box over some. With the Select tool the keys move, "
                        "turn and scale the whole object.",
                        of_a_step);
}

} // namespace trivar
