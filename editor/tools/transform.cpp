// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/transform.h"

#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "editor/tools/gesture_keys.h"
#include "editor/tools/select.h"
#include "ui/icons.h"

#include <imgui.h>

namespace trivar {

std::string TransformTool::name() const
{
    return kind_ == MotionKind::move ? "Move" : kind_ == MotionKind::rotate ? "Rotate" : "Scale";
}

const char* TransformTool::icon() const
{
    return kind_ == MotionKind::move     ? ui::icon::move
           : kind_ == MotionKind::rotate ? ui::icon::rotate
                                         : ui::icon::scale;
}

std::string TransformTool::help() const
{
    return kind_ == MotionKind::move     ? "Drag an arrow, a plane or the middle."
           : kind_ == MotionKind::rotate ? "Drag a ring round the selected objects."
                                         : "Drag a box, a plane or the middle.";
}

std::vector<ui::Chord> TransformTool::keys() const
{
    return {{kind_ == MotionKind::move ? 'G' : kind_ == MotionKind::rotate ? 'R' : 'S'}};
}

std::optional<MotionFrame> TransformTool::handles_at(const Session& session) const
{
    const std::vector<Stand> stands = stands_of(session.document(), session.selected.ids());
    if (stands.empty()) return {};
    const Id active = session.selected;
    const Box seen =
        choices_->pivot == Pivot::center ? bounds_of(session, session.selected.ids()) : Box{};
    return MotionFrame{pivot_of(stands, active, choices_->pivot, seen),
                       shared_axes(stands, active, choices_->orientation, session.view.camera)};
}

bool TransformTool::awaits(const ui::Chord& chord) const
{
    constexpr double patience_s = 2;
    return chord.key >= 'X' && chord.key <= 'Z' && !chord.ctrl && !chord.alt &&
           ImGui::GetTime() - refused_s_ < patience_s;
}

void TransformTool::begin(Session& session)
{
    refused_s_ = -1e9;
    if (session.selected == 0 || session.committing()) return;
    if (!handles_at(session)) {
        refused_s_ = ImGui::GetTime();
        if (locked(session.document(), session.selected)) {
            session.notices.say(ui::NoticeKind::warning,
                                name_of(session.document(), session.selected) + " is locked",
                                "Unlock it in the outliner to move it.");
            return;
        }
        const Id lies = session.selected;
        session.notices.say(ui::NoticeKind::warning,
                            name_of(session.document(), lies) + " lies on its stroke",
                            "Draw another stroke to lay it elsewhere, or take it off the stroke.",
                            "on a stroke", {{"Take off the stroke", [&session, lies] {
                                                 if (session.run(Unplace{lies}))
                                                     session.selected = lies;
                                             }}});
        return;
    }
    beginning_ = by_key_ = true;
}

void TransformTool::start(const Session& session, const Grasp& grasp)
{
    gesture_.emplace(kind_, stands_of(session.document(), session.selected.ids()),
                     session.selected.active(), *choices_, session.view.camera, grasp);
    shown_.clear();
}

void TransformTool::use(Session& session, const ViewportInput& input)
{
    outside_ = !input.hovered;
    const auto frame = gesture_ ? std::nullopt : handles_at(session);
    if (beginning_ && frame) start(session, {frame->pivot, {}, input.mouse, input.scale});
    beginning_ = false;
    if (!gesture_) {
        hovered_ = {};
        const double scale = input.scale;
        if (frame && (input.hovered || input.pressed))
            hovered_ = handle_at(gizmo_shapes(kind_, session.view.camera, *frame, scale),
                                 glm::vec2(input.mouse), scale);
        if (hovered_.grip != Grip::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (!input.pressed || session.committing()) return;
        if (!frame || hovered_.grip == Grip::none) {
            select_by_click(session, input.under);
            return;
        }
        by_key_ = false;
        start(session, {frame->pivot, hovered_, input.mouse, input.scale});
        return;
    }
    const ImGuiIO& io = ImGui::GetIO();
    gesture_->move_hand(session.view.camera, input.mouse,
                        {.snap = io.KeyCtrl, .fine = io.KeyShift});
    if (by_key_ ? input.pressed : input.released)
        finish(session);
    else if (by_key_ || gesture_->typed().open() || gesture_->travelled_px() >= click_slip_px)
        show(session);
}

void TransformTool::show(Session& session)
{
    // One proposal at a time: the next waits until the last one can be seen.
    if (!session.up_to_date()) return;
    std::vector<Transform> wanted = gesture_->transforms();
    if (wanted == shown_) return;
    if (session.propose_quietly(arranged(gesture_->ids(), wanted))) shown_ = std::move(wanted);
}

void TransformTool::finish(Session& session)
{
    const TransformGesture done = *gesture_;
    gesture_.reset();
    const bool by_hand = by_key_ || done.travelled_px() >= click_slip_px;
    const bool nothing = done.motion().is_nothing();
    if (nothing || !(by_hand || done.typed().open()) ||
        !session.propose(arranged(done.ids(), done.transforms())))
        session.cancel();
    else
        session.commit();
}

void TransformTool::cancel(Session& session)
{
    beginning_ = false;
    if (!gesture_) return;
    gesture_.reset();
    session.cancel();
}

void TransformTool::take_keys(Session& session)
{
    if (!gesture_) return;
    const bool ended = take_gesture_keys(*gesture_);
    // A click elsewhere in the window ends it too, before the panel there sees the click.
    const bool elsewhere = by_key_ && outside_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (ended || elsewhere) finish(session);
}

} // namespace trivar
