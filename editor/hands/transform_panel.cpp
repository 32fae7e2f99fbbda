// SPDX-License-Identifier: GPL-3.0-or-later
// What the transform tools show: handles, the axis at work, the amount, settings and hints.
#include "core/commands/words/field_words.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/transform.h"
#include "editor/hands/viewport_input.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

void amount_chip(const ui::Theme& theme, const ViewportInput& input, const std::string& words)
{
    const float width = ui::text_width(theme.font.small, words) + theme.px(16);
    const glm::vec2 lo = input.rect.lo + theme.px(8);
    const glm::vec2 hi = input.rect.hi - theme.px(8) - glm::vec2(width, theme.size.row);
    const glm::vec2 at =
        input.rect.lo + glm::vec2(input.mouse) + glm::vec2(theme.px(24), theme.px(-32));
    ui::paint_chip(theme, glm::round(glm::clamp(at, lo, glm::max(lo, hi))), {words});
}

Hint hint(std::vector<std::string> inputs, std::string verb)
{
    return {std::move(inputs), std::move(verb)};
}

} // namespace

void TransformTool::overlay(const Session& session, const ui::Theme& theme,
                            const ViewportInput& input) const
{
    const glm::vec2 at = input.rect.lo;
    ImGui::PushClipRect({at.x, at.y}, {input.rect.hi.x, input.rect.hi.y}, true);
    if (gesture_)
        gesture_overlay(session, theme, input);
    else if (handles_at(session))
        paint_gizmo(theme, at, handles(session, theme.scale), hovered_);
    ImGui::PopClipRect();
}

void TransformTool::gesture_overlay(const Session& session, const ui::Theme& theme,
                                    const ViewportInput& input) const
{
    const Camera& camera = session.view.camera;
    const MotionFrame frame = gesture_->frame();
    const GizmoHandle& held = gesture_->constraint();
    const bool free = held.grip == Grip::none, plane = held.grip == Grip::plane;
    for (int axis = 0; axis < 3; ++axis)
        if (!free && (axis == held.axis) != plane)
            paint_axis_line(theme, input.rect, camera, frame, axis);
    const glm::vec2 pivot = input.rect.lo + glm::vec2(project(camera, frame.pivot).p_px);
    const glm::vec2 hand = input.rect.lo + glm::vec2(input.mouse);
    if (kind_ == MotionKind::scale) {
        ui::paint_line(pivot, hand, theme.color.halo, 3 * theme.scale);
        ui::paint_line(pivot, hand, theme.color.selected, theme.scale);
    }
    if (kind_ == MotionKind::rotate) {
        const glm::dvec3 about = gesture_->turn_axis_world();
        const auto from = point_in_plane(camera, frame.pivot, about, gesture_->from_px());
        paint_turn(theme, input.rect.lo, camera, frame.pivot, about,
                   from ? *from - frame.pivot : view_axes(camera)[0], gesture_->motion().angle_deg,
                   free ? theme.color.selected : axis_color(theme, held.axis));
    }
    ui::paint_dot(pivot, theme.px(4), theme.color.selected, theme.color.halo, 1.5f * theme.scale);
    if (input.rect.contains(hand)) amount_chip(theme, input, amount(session));
}

void TransformTool::options(Session& session, const ui::Theme& theme, float width)
{
    const bool laid = laid_stand(session).has_value(); // it has its own axes, and its own pivot
    const bool roomy = width >= theme.px(640);         // else the choices are lists
    const auto one_of = [&](const char* id, auto& value, const std::vector<std::string>& names) {
        return [&theme, &value, roomy, id, names](float field) {
            int chosen = static_cast<int>(value);
            if (roomy)
                ui::segments(theme, id, chosen, names, field);
            else
                ui::choice(theme, id, chosen, names, field);
            value = static_cast<std::remove_reference_t<decltype(value)>>(chosen);
        };
    };
    TransformChoices& c = *choices_;
    std::vector<ui::Option> options;
    const auto setting = [&](const char* words, float field_px, auto field, const char* help) {
        options.push_back({words, field_px, std::move(field), help});
    };
    if (!laid)
        setting("Axes", roomy ? 168 : 88, one_of("axes", c.orientation, {"World", "Local", "View"}),
                "The directions of the handles and of X, Y and Z.");
    if (!laid)
        setting("Pivot", roomy ? 216 : 88,
                one_of("pivot", c.pivot, {"Origin", "Centre", "Each", "Active"}),
                "The point about which objects rotate and scale.");
    setting(
        "Ctrl snaps to", 88,
        [&](float field) {
            ui::NumberStyle style{.lo = 1e-6, .hi = 1e6};
            if (kind_ == MotionKind::move) style.unit = "m";
            if (kind_ == MotionKind::rotate) style.unit = "deg";
            double& step = kind_ == MotionKind::move     ? c.step_m
                           : kind_ == MotionKind::rotate ? c.step_deg
                                                         : c.step_factor;
            ui::number_field(theme, "step", step, style, field);
        },
        "The step of a drag while Ctrl is held.");
    ui::option_bar(theme, options, width);
}

// Where a hand slides it over a surface it is the way there that counts.
std::string TransformTool::amount(const Session& session) const
{
    if (!laid_ || kind_ != MotionKind::move || !gesture_->free()) return gesture_->amount();
    const MotionFrame frame = gesture_->frame();
    const auto laid = laid_stand(session);
    return in_metres(laid ? glm::distance(laid->frame().pivot, frame.pivot) : 0);
}

std::string TransformTool::words(const Session& session) const
{
    if (!laid_) return gesture_->words();
    if (kind_ == MotionKind::move && gesture_->free()) return "Slide " + amount(session);
    const bool turns = kind_ == MotionKind::rotate;
    return turns ? "Turn on the surface " + gesture_->amount() : gesture_->words();
}

std::vector<Hint> TransformTool::hints(const Session& session) const
{
    return gesture_ ? hints_at_work(session) : hints_at_rest(session);
}

std::vector<Hint> TransformTool::hints_at_work(const Session& session) const
{
    std::vector<Hint> hints;
    hints.push_back(hint({}, words(session)));
    const bool typing = gesture_->typed().open();
    if (typing)
        hints.push_back(hint({"Enter"}, "Done"));
    else if (gesture_.by_key())
        hints.push_back(hint({"left", "/", "Enter"}, "Done"));
    else
        hints.push_back(hint({"left"}, "Let go when done"));
    hints.push_back(hint({"Esc", "/", "right"}, "Cancel"));
    if (typing && gesture_->numbers() > 1) hints.push_back(hint({"Tab"}, "Next number"));
    if (laid_ && kind_ == MotionKind::move)
        hints.push_back(hint({"X", "Y", "Z"}, "Along, across, off the surface"));
    else if (laid_ && kind_ == MotionKind::scale)
        hints.push_back(hint({"X", "Y", "Z"}, "Length, width, height"));
    else if (!laid_)
        hints.push_back(hint({"X", "Y", "Z"}, "Axis"));
    if (kind_ != MotionKind::rotate && !laid_)
        hints.push_back(hint({"Shift", "X", "Y", "Z"}, "Plane"));
    if (typing) return hints;
    hints.push_back(hint({"0-9"}, "Type it"));
    hints.push_back(hint({"Ctrl"}, "Snap"));
    hints.push_back(hint({"Shift"}, "Fine"));
    return hints;
}

std::vector<Hint> TransformTool::hints_at_rest(const Session& session) const
{
    std::vector<Hint> hints;
    const char* reset = kind_ == MotionKind::move     ? "@Reset position"
                        : kind_ == MotionKind::rotate ? "@Reset rotation"
                                                      : "@Reset scale";
    if (const auto frame = handles_at(session)) {
        const PicturePoint middle = project(session.view.camera, frame->pivot);
        const bool seen = middle.depth_world > 0 &&
                          glm::all(glm::greaterThan(middle.p_px, {0, 0})) &&
                          glm::all(glm::lessThan(middle.p_px, session.view.camera.size_px));
        if (seen) hints.push_back(hint({"left"}, "Drag a handle"));
        hints.push_back(hint({"@" + name()}, name() + " freely"));
        if (!laid_stand(session)) hints.push_back(hint({reset}, "Reset"));
        if (!seen) hints.push_back(hint({"@Frame selection"}, "Frame it to see the handles"));
    }
    hints.push_back(hint({"left"}, "Select"));
    hints.push_back(hint({"Shift", "left"}, "Add or remove"));
    hints.push_back(hint({"middle"}, "Orbit"));
    hints.push_back(hint({"Esc"}, "Back to Select"));
    return hints;
}

} // namespace trivar
