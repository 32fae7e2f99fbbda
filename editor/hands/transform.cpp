// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/transform.h"

#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"

#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

constexpr GizmoHandle about_surface{Grip::ring, 2}; // of what lies on a stroke

} // namespace

std::optional<MotionFrame> TransformTool::handles_at(const Session& session) const
{
    if (const auto laid = laid_stand(session)) return laid->frame();
    const std::vector<Stand> stands = stands_of(session.document(), session.selected.ids());
    if (stands.empty()) return {};
    const Id active = session.selected;
    const Box seen =
        choices_->pivot == Pivot::center ? bounds_of(session, session.selected.ids()) : Box{};
    return MotionFrame{pivot_of(stands, active, choices_->pivot, seen),
                       shared_axes(stands, active, choices_->orientation, session.view.camera)};
}

std::vector<HandleShape> TransformTool::handles(const Session& session, double scale) const
{
    const auto frame = handles_at(session);
    if (!frame) return {};
    std::vector<HandleShape> shapes = gizmo_shapes(kind_, session.view.camera, *frame, scale);
    if (kind_ == MotionKind::rotate && laid_stand(session))
        std::erase_if(shapes,
                      [](const HandleShape& shape) { return shape.handle != about_surface; });
    return shapes;
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
    if (session.selected == 0) return;
    if (!handles_at(session) && !is_coming(session)) return refuse(session);
    beginning_ = true;
}

bool TransformTool::is_coming(const Session& session) const
{
    if (session.committing()) return true;
    const auto found = session.document().objects.find(session.selected);
    return found != session.document().objects.end() && found->second->stroke &&
           !session.up_to_date() && !laid_stand(session);
}

void TransformTool::refuse(Session& session)
{
    refused_s_ = ImGui::GetTime();
    const Id lies = session.selected;
    const std::string name = name_of(session.document(), lies);
    if (locked(session.document(), lies)) {
        session.notices.say(ui::NoticeKind::warning, name + " is locked",
                            "Unlock it in the outliner to move it.");
        return;
    }
    if (session.selected.size() > 1) {
        session.notices.say(ui::NoticeKind::warning, "All of these lie on strokes",
                            "Select one of them: each moves over its own surface.", "on a stroke");
        return;
    }
    const auto& step = object(session.document(), lies).stroke;
    const bool round = step && step->round;
    session.notices.say(
        ui::NoticeKind::warning,
        round ? name + " goes round its host" : name + " has nothing to lie on",
        round ? "Its level, start and fill set its place. Draw a stroke to lay it "
                "elsewhere, or remove it from its stroke."
              : "Draw another stroke to lay it elsewhere, or remove it from its stroke.",
        "on a stroke", {{"Remove from stroke", [&session, lies] {
                             if (session.run(Unplace{lies})) session.selected = lies;
                         }}});
}

void TransformTool::start(const Session& session, const ViewportInput& input, Grasp grasp,
                          bool by_key)
{
    laid_ = laid_stand(session);
    TransformChoices choices = *choices_;
    std::vector<Stand> stands;
    if (laid_) {
        stands.push_back(laid_->stand());
        choices.orientation = Orientation::local;
        grasp.own_axes = true;
        if (kind_ == MotionKind::rotate) grasp.handle = about_surface;
    } else
        stands = stands_of(session.document(), session.selected.ids());
    gesture_.begin(TransformGesture(kind_, std::move(stands), session.selected.active(), choices,
                                    session.view.camera, grasp),
                   input, by_key);
    last_.reset();
}

void TransformTool::use(Session& session, const ViewportInput& input)
{
    const auto frame = gesture_ ? std::nullopt : handles_at(session);
    if (beginning_ && is_coming(session)) return;
    if (beginning_ && frame)
        start(session, input, {frame->pivot, {}, input.mouse, input.scale}, true);
    else if (beginning_ && session.selected != 0)
        refuse(session);
    beginning_ = false;
    if (gesture_) {
        gesture_.go_on(
            session, input, [&] { return wanted_last(session.view.camera); },
            [&] { commit(session); });
        return;
    }
    hovered_ = {};
    const double scale = input.scale;
    if (frame && (input.hovered || input.pressed))
        hovered_ = handle_at(handles(session, scale), glm::vec2(input.mouse), scale);
    if (hovered_.grip != Grip::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!input.pressed || session.committing()) return;
    if (hovered_.grip == Grip::none)
        select_by_click(session, input.under);
    else
        start(session, input, {frame->pivot, hovered_, input.mouse, scale}, false);
}

std::optional<Command> TransformTool::wanted(const Camera& camera) const
{
    if (!laid_) return arranged(gesture_->ids(), gesture_->transforms());
    const Motion motion = gesture_->motion();
    const MotionFrame frame = gesture_->frame();
    if (kind_ == MotionKind::move && gesture_->free())
        return moved_under(*laid_, frame.pivot + frame.axes * motion.offset, camera);
    return moved(*laid_, motion, frame);
}

std::optional<Command> TransformTool::wanted_last(const Camera& camera)
{
    if (const std::optional<Command> now = wanted(camera)) last_ = now;
    return last_;
}

void TransformTool::commit(Session& session)
{
    if (laid_)
        session.commit_if_placed(laid_->object);
    else
        session.commit();
}

void TransformTool::cancel(Session& session)
{
    beginning_ = false;
    gesture_.cancel(session);
}

void TransformTool::take_keys(Session& session)
{
    if (gesture_ && gesture_.take_keys())
        gesture_.finish(
            session, [&] { return wanted_last(session.view.camera); }, [&] { commit(session); });
}

} // namespace trivar
