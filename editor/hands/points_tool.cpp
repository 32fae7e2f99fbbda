// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/points_tool.h"

#include "core/commands/edits/edits.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "ui/input.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>
#include <numeric>

namespace trivar {
namespace {

std::vector<bool> flags_of(const std::vector<int>& points, std::size_t count)
{
    std::vector<bool> out(count);
    for (const int i : points) out[static_cast<std::size_t>(i)] = true;
    return out;
}

} // namespace

ToolState PointsTool::state() const
{
    return {.busy = gesture_ || box_px_,
            .takes_wheel = gesture_ && proportional_,
            .shows_volume_at_work = true};
}

bool PointsTool::choose(Session& session, PartChoice choice)
{
    look(session);
    if (object_ == 0 || choice == PartChoice::same) return false; // all points are alike
    if (choice == PartChoice::more) {
        chosen_ = chosen_and_next();
        return true;
    }
    std::vector<bool> known(at_world_.size(), choice == PartChoice::none);
    if (choice == PartChoice::others) known = flags_of(chosen_, at_world_.size());
    chosen_.clear();
    for (std::size_t i = 0; i < known.size(); ++i)
        if (!known[i]) chosen_.push_back(static_cast<int>(i));
    return true;
}

bool PointsTool::grab(Session& session, MotionKind kind)
{
    look(session);
    grabbing_.reset();
    if (object_ == 0) return false;
    if (chosen_.empty())
        say_no_point_is_selected(session);
    else if (!session.committing())
        grabbing_ = kind;
    return true;
}

std::optional<int> PointsTool::point_at(const Camera& camera, const ViewportInput& input) const
{
    std::optional<int> nearest;
    double distance = reach_px_.mouse * input.scale, depth = 1e300;
    for (std::size_t i = 0; i < at_world_.size(); ++i) {
        const PicturePoint p = project(camera, at_world_[i]);
        const double far = glm::distance(p.p_px, input.mouse);
        if (p.depth_world <= 0 || far > distance + reach_px_.cover ||
            (far >= distance - reach_px_.cover && p.depth_world > depth))
            continue;
        distance = std::min(distance, far);
        depth = p.depth_world;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

void PointsTool::use(Session& session, const ViewportInput& input)
{
    look(session);
    if (gesture_) {
        if (chosen_.empty()) return cancel(session);
        if (input.wheel != 0) resize(session, std::pow(radius_step, input.wheel));
        return ended(gesture_.go_on(session, input, [&] { return wanted(session); }));
    }
    hovered_.reset();
    hovered_handle_ = {};
    if (object_ == 0) {
        box_px_.reset();
        if (!input.pressed) return;
        const Id cage = cage_of(session, input.under);
        return select_by_click(session, cage != 0 ? cage : input.under);
    }
    if (box_px_) {
        if (input.released || !input.down) end_box(session, input);
        return;
    }
    if (const auto kind = std::exchange(grabbing_, std::nullopt); kind && !chosen_.empty())
        return begin(session, input, {}, *kind);
    if (!input.hovered && !input.pressed) return;
    const Camera& camera = session.view.camera;
    if (!chosen_.empty())
        hovered_handle_ =
            handle_at(gizmo_shapes(MotionKind::move, camera, frame(session), input.scale),
                      glm::vec2(input.mouse), input.scale);
    // The middle of the handles covers a single chosen point: both move it.
    if (hovered_handle_.grip == Grip::none || hovered_handle_.grip == Grip::center ||
        input.double_clicked)
        hovered_ = point_at(camera, input);
    if (hovered_ || hovered_handle_.grip != Grip::none)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (input.pressed && !session.committing()) press(session, input);
}

void PointsTool::press(Session& session, const ViewportInput& input)
{
    if (input.double_clicked && hovered_) return choose_line(session);
    pressed_ = hovered_;
    const bool handle = hovered_handle_.grip != Grip::none;
    if (hovered_ && (handle ? ImGui::GetIO().KeyCtrl : adds_to_selection())) {
        if (std::erase(chosen_, *hovered_) == 0) chosen_.push_back(*hovered_);
    } else if (handle) {
        begin(session, input, hovered_handle_);
    } else if (hovered_) {
        if (std::ranges::find(chosen_, *hovered_) == chosen_.end()) chosen_ = {*hovered_};
        begin(session, input, {Grip::center, 0});
    } else {
        box_px_ = input.mouse;
    }
}

void PointsTool::end_box(Session& session, const ViewportInput& input)
{
    const glm::dvec2 from = *std::exchange(box_px_, std::nullopt);
    if (glm::distance(from, input.mouse) < click_slip_px) {
        if (input.under != 0 && cage_of(session, input.under) != object_)
            select_by_click(session, input.under);
        else if (!adds_to_selection())
            chosen_.clear();
        return;
    }
    const glm::dvec2 lo = glm::min(from, input.mouse), hi = glm::max(from, input.mouse);
    if (!adds_to_selection()) chosen_.clear();
    const std::vector<bool> before = flags_of(chosen_, at_world_.size());
    for (std::size_t i = 0; i < at_world_.size(); ++i) {
        const PicturePoint p = project(session.view.camera, at_world_[i]);
        if (p.depth_world > 0 && glm::all(glm::greaterThanEqual(p.p_px, lo)) &&
            glm::all(glm::lessThanEqual(p.p_px, hi)) && !before[i])
            chosen_.push_back(static_cast<int>(i));
    }
}

void PointsTool::begin(const Session& session, const ViewportInput& input,
                       const GizmoHandle& handle, MotionKind kind)
{
    begin_motion(session);
    // The gesture is that of an object which stands there, turned as the volume is.
    gesture_.begin(kind, object_, frame(session), handle, session.view.camera, input);
}

void PointsTool::ended(Gesture::State state)
{
    if (state == Gesture::State::done) committed();
    const bool clicked = state == Gesture::State::dropped && !gesture_.meant() && pressed_;
    if (clicked && *pressed_ < std::ssize(at_world_)) chosen_ = {*pressed_};
}

void PointsTool::cancel(Session& session)
{
    box_px_.reset();
    gesture_.cancel(session);
}

void PointsTool::take_keys(Session& session)
{
    if (!gesture_) return;
    const bool ends = gesture_.take_keys();
    if (!gesture_.types_formula() && ui::struck({'O'})) proportional_ = !proportional_;
    for (const auto& [key, steps] : {std::pair(ui::key_page_up, 1), {ui::key_page_down, -1}})
        if (ui::struck({key}, true)) resize(session, std::pow(radius_step, steps));
    if (ends) ended(gesture_.finish(session, [&] { return wanted(session); }));
}

std::vector<std::string> PointsTool::numbers_below(const std::string& name)
{
    std::vector<std::string> out;
    for (const char* part : {"by", "rotation_deg", "factors"})
        for (const char axis : {'x', 'y', 'z'})
            out.push_back(fmt::format("{}.{}.{}", name, part, axis));
    return out;
}

glm::dvec3 PointsTool::turn_of(const Motion& motion, const glm::dvec3& axis)
{
    const glm::dvec3 unit = without_rounding(glm::normalize(axis));
    glm::dvec3 out(0);
    for (int a = 0; a < 3; ++a) // about one of them it may be more than a whole turn
        if (std::abs(unit[a]) == 1) out[a] = unit[a] * motion.angle_deg;
    if (out != glm::dvec3(0)) return out;
    return decomposed(glm::rotate(glm::dmat4(1), glm::radians(motion.angle_deg), unit))
        .rotation_deg;
}

} // namespace trivar
