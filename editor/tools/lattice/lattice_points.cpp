// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/lattice_points.h"

#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"
#include "core/placement/shifting.h"
#include "core/steps/laying/attaching.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/last_shaping.h"
#include "editor/hands/select.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/shown_points.h"
#include "editor/session/topics.h"
#include "ui/icons.h"
#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>
#include <set>
#include <tuple>

namespace trivar {
namespace {

constexpr double point_reach_px = 10; // of the mouse, at scale 1

// The axis of a volume's row through a point that is seen longest, or of the plane through it that
// looks at the eye most.
int clearest_axis(const Lattice& volume, const Camera& camera, const glm::ivec3& p, bool plane)
{
    const VolumeDirections at = volume_directions(volume, greville(volume, p));
    const glm::dvec3 eye = toward_eye(camera, control_point(volume, p.x, p.y, p.z));
    const std::array<double, 3> facing{std::abs(glm::dot(at.along, eye)),
                                       std::abs(glm::dot(at.across, eye)),
                                       std::abs(glm::dot(at.up, eye))};
    const auto best = plane ? std::ranges::max_element(facing) : std::ranges::min_element(facing);
    return static_cast<int>(best - facing.begin());
}

// Rounding by a transform that was undone is no digit of what a hand or keys said.
glm::dvec3 without_rounding(const glm::dvec3& v)
{
    return glm::round(v * 1e9) / 1e9;
}

// Which of a volume's control points are among those, by their index.
std::vector<char> flags_of(const Lattice& volume, const std::vector<glm::ivec3>& points)
{
    std::vector<char> out(volume.displacement.points.size());
    for (const glm::ivec3& p : points) out[volume.displacement.index(p.x, p.y, p.z)] = 1;
    return out;
}

// The points that take all of a step.
std::vector<glm::ivec3> fully_held(const PointShift& shift)
{
    std::vector<glm::ivec3> out;
    for (std::size_t i = 0; i < shift.points.size(); ++i)
        if (shift.weights.empty() || shift.weights[i] == 1) out.push_back(shift.points[i]);
    return out;
}

// Whether they are the same points, in whatever order.
bool are_alike(const std::vector<glm::ivec3>& a, const std::vector<glm::ivec3>& b)
{
    const auto less = [](const glm::ivec3& p, const glm::ivec3& q) {
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    };
    return std::set(a.begin(), a.end(), less) == std::set(b.begin(), b.end(), less);
}

bool has(const std::vector<glm::ivec3>& points, const glm::ivec3& point)
{
    return std::ranges::find(points, point) != points.end();
}

// Along each axis at a control point: the length of a small piece of the volume, by that of the
// same piece as it is seen.
glm::dvec3 own_by_seen(const Lattice& own, const Lattice& seen, const glm::ivec3& point)
{
    const glm::dvec3 at = greville(own, point);
    const auto a = evaluate(own, at, 1).first, b = evaluate(seen, at, 1).first;
    glm::dvec3 out(1);
    for (int axis = 0; axis < 3; ++axis) {
        const auto n = static_cast<std::size_t>(axis);
        if (const double length = glm::length(b[n]); length > 0 && a[n] != b[n])
            out[axis] = glm::length(a[n]) / length;
    }
    return out;
}

} // namespace

const char* LatticePointsTool::icon() const
{
    return ui::icon::volume;
}

PointShift LatticePointsTool::held() const
{
    return {.points = chosen_,
            .mirror = mirror_.y,
            .guard = guard_,
            .of = of_,
            .mirror_along = mirror_.x,
            .mirror_up = mirror_.z};
}

MotionFrame LatticePointsTool::frame_of(const Lattice& volume) const
{
    const VolumeDirections at = volume_directions(volume, greville(volume, chosen_.front()));
    PointShift shift = held();
    if (proportional_.on) shift.weights.assign(chosen_.size(), 1);
    return {middle_of(volume, shift), glm::dmat3(at.along, at.across, at.up)};
}

double LatticePointsTool::radius(const Lattice& volume) const
{
    if (proportional_.radius_m > 0) return proportional_.radius_m;
    constexpr double share = 0.5; // of the longest side as it was laid
    double longest = 0;
    for (int a = 0; a < 3; ++a)
        longest = std::max(longest, glm::length(glm::dvec3(volume.rest[a])));
    return rounded(share * longest, 2);
}

void LatticePointsTool::keep_what_is_there(const Session& session)
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) chosen_.clear();
    object_ = laid ? laid->id : 0;
    if (!laid) return;
    chosen_ = within(std::move(chosen_), point_count(laid->placement->volume));
}

Ref<Lattice> LatticePointsTool::cage(const Session& session) const
{
    return selected_volume(session)->seen_cage();
}

std::optional<glm::ivec3> LatticePointsTool::point_at(const Session& session,
                                                      const ViewportInput& input) const
{
    std::optional<glm::ivec3> nearest;
    double distance = point_reach_px * input.scale;
    each_point(*cage(session), session.view.camera, [&](const glm::ivec3& p, glm::dvec2 at) {
        const double far = glm::distance(at, input.mouse);
        if (far >= distance) return;
        distance = far;
        nearest = p;
    });
    return nearest;
}

bool LatticePointsTool::grab(Session& session, MotionKind kind)
{
    keep_what_is_there(session);
    grabbing_.reset();
    if (object_ == 0) return false;
    if (chosen_.empty())
        say_no_point_is_selected(session);
    else if (!session.committing())
        grabbing_ = kind;
    return true;
}

std::optional<std::vector<std::string>> LatticePointsTool::numbers(const Session& session) const
{
    if (chosen_.empty() || object_ != session.selected) return {};
    std::vector<std::string> names;
    const std::vector<Ref<VolumeEdit>>& steps = object(session.document(), object_).shaping;
    for (std::size_t i = steps.size(); i-- > 0 && names.empty();) {
        if (!steps[i]->shift || !are_alike(fully_held(*steps[i]->shift), chosen_)) continue;
        for (const char* part : {"by", "rotation_deg", "factors"})
            for (const char axis : {'x', 'y', 'z'})
                names.push_back(fmt::format("shaping.{}.shift.{}.{}", i, part, axis));
    }
    return names;
}

bool LatticePointsTool::choose_parts(Session& session, PartChoice choice)
{
    keep_what_is_there(session);
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid) return false;
    const glm::ivec3 n = point_count(laid->placement->volume);
    switch (choice) {
    case PartChoice::all: chosen_ = all_points(n); break;
    case PartChoice::none: chosen_.clear(); break;
    case PartChoice::others: chosen_ = others(chosen_, n); break;
    case PartChoice::more: chosen_ = with_next(chosen_, n); break;
    case PartChoice::same: return false; // all points are alike
    }
    return true;
}

bool LatticePointsTool::resize(Session& session, double factor)
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || !proportional_.on) return false;
    proportional_.radius_m =
        std::clamp(rounded(radius(laid->placement->volume) * factor, 3), 1e-6, 1e6);
    return true;
}

void LatticePointsTool::use(Session& session, const ViewportInput& input)
{
    tell(session);
    keep_what_is_there(session);
    if (gesture_) {
        if (chosen_.empty()) return cancel(session);
        return go_on(session, input);
    }
    hovered_.reset();
    hovered_handle_ = {};
    if (object_ == 0) {
        box_px_.reset();
        if (input.pressed) select_by_click(session, input.under);
        return;
    }
    const Ref<Lattice> seen = cage(session);
    const Lattice& volume = *seen;
    if (box_px_) {
        if (!input.released && input.down) return;
        if (glm::distance(*box_px_, input.mouse) >= click_slip_px)
            choose_in_box(session, input);
        else if (input.under != 0 && input.under != object_)
            select_by_click(session, input.under);
        else if (!adds_to_selection())
            chosen_.clear();
        box_px_.reset();
        return;
    }
    if (const auto kind = std::exchange(grabbing_, std::nullopt); kind && !chosen_.empty()) {
        return begin(session, input, {}, *kind);
    }
    if (!input.hovered && !input.pressed) return;
    if (!chosen_.empty())
        hovered_handle_ = handle_at(
            gizmo_shapes(MotionKind::move, session.view.camera, frame_of(volume), input.scale),
            glm::vec2(input.mouse), input.scale);
    // The middle of the handles covers a single chosen point: both move it.
    if (hovered_handle_.grip == Grip::none || hovered_handle_.grip == Grip::center ||
        input.double_clicked)
        hovered_ = point_at(session, input);
    if (hovered_ || hovered_handle_.grip != Grip::none)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!input.pressed || session.committing()) return;
    if (input.double_clicked && hovered_) return choose_line(session);
    pressed_ = hovered_;
    if (hovered_ && ImGui::GetIO().KeyCtrl)
        choose(session, input);
    else if (hovered_handle_.grip != Grip::none)
        begin(session, input, hovered_handle_);
    else if (hovered_)
        choose(session, input);
    else
        box_px_ = input.mouse;
}

void LatticePointsTool::choose(const Session& session, const ViewportInput& input)
{
    const glm::ivec3 point = *hovered_;
    if (adds_to_selection()) {
        if (std::erase(chosen_, point) == 0) chosen_.push_back(point);
        return;
    }
    if (!has(chosen_, point)) chosen_ = {point};
    begin(session, input, {Grip::center, 0});
}

void LatticePointsTool::choose_line(const Session& session)
{
    const ImGuiIO& io = ImGui::GetIO();
    const Ref<Lattice> seen = cage(session);
    const Lattice& volume = *seen;
    const bool again = line_at_ == hovered_ && line_is_plane_ == io.KeyShift;
    line_axis_ = again ? (line_axis_ + 1) % 3
                       : clearest_axis(volume, session.view.camera, *hovered_, io.KeyShift);
    line_at_ = hovered_;
    line_is_plane_ = io.KeyShift;
    const glm::ivec3 n = point_count(volume);
    if (!io.KeyCtrl) chosen_.clear();
    for (const glm::ivec3& p :
         line_is_plane_ ? plane_of(*hovered_, line_axis_, n) : row_of(*hovered_, line_axis_, n))
        if (!has(chosen_, p)) chosen_.push_back(p);
}

void LatticePointsTool::choose_in_box(const Session& session, const ViewportInput& input)
{
    const glm::dvec2 lo = glm::min(*box_px_, input.mouse), hi = glm::max(*box_px_, input.mouse);
    if (!adds_to_selection()) chosen_.clear();
    const Ref<Lattice> seen = cage(session);
    const Lattice& volume = *seen;
    const std::vector<char> before = flags_of(volume, chosen_);
    each_point(volume, session.view.camera, [&](const glm::ivec3& p, glm::dvec2 at) {
        const bool inside =
            glm::all(glm::greaterThanEqual(at, lo)) && glm::all(glm::lessThanEqual(at, hi));
        if (inside && before[volume.displacement.index(p.x, p.y, p.z)] == 0) chosen_.push_back(p);
    });
}

void LatticePointsTool::begin(const Session& session, const ViewportInput& input,
                              const GizmoHandle& handle, MotionKind kind)
{
    const Lattice& volume = selected_volume(session)->placement->volume;
    of_ = point_count(volume);
    kind_ = kind;
    const Ref<Lattice> seen = cage(session);
    const MotionFrame frame = frame_of(*seen);
    world_axes_ = frame_of(volume).axes;
    own_by_seen_ = own_by_seen(volume, *seen, chosen_.front());
    // A lattice's steps are of the box before the object's transform, those of a stroke of the
    // space that it was drawn in.
    const bool box = is_lattice(session.document(), object_);
    const glm::dmat4 from_world = box ? glm::inverse(to_world(session.shown(), object_))
                                      : glm::inverse(stroke_to_world(*selected_volume(session)));
    from_world_ = glm::dmat3(from_world);
    axes_ = world_axes_;
    if (from_world != glm::dmat4(1)) {
        Lattice before = volume;
        before.rest = from_world * before.rest;
        for (glm::dvec3& d : before.displacement.points) d = from_world_ * d;
        const VolumeDirections at = volume_directions(before, greville(before, chosen_.front()));
        axes_ = glm::dmat3(at.along, at.across, at.up);
    }
    distances_ = by_distance(volume, held());
    proportional_.radius_m = radius(volume);
    gesture_.begin(kind, object_, frame, handle, session.view.camera, input);
    shown_ = {};
}

PointShift LatticePointsTool::shift() const
{
    const Motion motion = gesture_->motion();
    const glm::dmat3& world = world_axes_;
    const auto along = [&](const glm::dvec3& v) { // of its own directions, from the gesture's
        return without_rounding(glm::transpose(axes_) * (from_world_ * (world * v)));
    };
    const bool same = from_world_ == glm::dmat3(1) && world == axes_;
    PointShift out = held();
    if (motion.kind == MotionKind::move) out.by = same ? motion.offset : along(motion.offset);
    // A hand moves what it sees; numbers are those of the volume itself.
    if (!gesture_->typed().open()) out.by *= own_by_seen_;
    if (motion.kind == MotionKind::scale) out.factors = motion.factors;
    if (motion.kind == MotionKind::rotate) {
        const glm::dvec3 axis = without_rounding(glm::normalize(along(motion.turn_axis)));
        for (int a = 0; a < 3; ++a) // about one of them it may be more than a whole turn
            if (std::abs(axis[a]) == 1) out.rotation_deg[a] = axis[a] * motion.angle_deg;
        if (out.rotation_deg == glm::dvec3(0))
            out.rotation_deg =
                decomposed(glm::rotate(glm::dmat4(1), glm::radians(motion.angle_deg), axis))
                    .rotation_deg;
    }
    if (!proportional_.on) return out;
    return with_neighbours(std::move(out), distances_, proportional_.kind, proportional_.radius_m);
}

Command LatticePointsTool::wanted()
{
    shown_ = shift();
    return MovePoints{object_, shown_};
}

void LatticePointsTool::go_on(Session& session, const ViewportInput& input)
{
    if (input.wheel != 0) resize(session, std::pow(radius_step, input.wheel));
    const Gesture::State state = gesture_.go_on(session, input, [&] { return wanted(); });
    if (state == Gesture::State::done)
        told_of_ = object_;
    else if (state == Gesture::State::dropped && !gesture_.meant() && pressed_)
        chosen_ = {*pressed_};
}

void LatticePointsTool::tell(Session& session)
{
    if (told_of_ == 0 || gesture_ || !session.up_to_date()) return;
    const Shaping* last = last_shaping(session, std::exchange(told_of_, 0));
    if (last && last->would_fold)
        tell_where_it_stopped(session, *last, "The control points", "Move their neighbours too",
                              object_, held_parts(session));
}

std::vector<VolumePart> LatticePointsTool::held_parts(const Session& session) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) return {};
    const Lattice& volume = laid->placement->volume;
    const Points chosen = within(chosen_, point_count(volume));
    if (chosen.empty()) return {};
    return with_mirrored(bent_by(volume, chosen), mirror_.y);
}

void LatticePointsTool::cancel(Session& session)
{
    box_px_.reset();
    gesture_.cancel(session);
}

void LatticePointsTool::take_keys(Session& session)
{
    if (!gesture_) return;
    const bool ended = gesture_.take_keys();
    if (!gesture_.types_formula() && ui::struck({'O'})) proportional_.on = !proportional_.on;
    for (const auto& [key, steps] : {std::pair(ui::key_page_up, 1), {ui::key_page_down, -1}})
        if (ui::struck({key}, true)) resize(session, std::pow(radius_step, steps));
    if (ended && gesture_.finish(session, [&] { return wanted(); }) == Gesture::State::done)
        told_of_ = object_;
}

} // namespace trivar
