// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/lattice_points.h"

#include "core/base/rounded.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/shape.h"
#include "core/placement/shifting.h"
#include "core/steps/laying/attaching.h"
#include "editor/hands/hand_motion.h"
#include "editor/hands/last_shaping.h"
#include "editor/hands/point_choice.h"
#include "editor/hands/selected_placement.h"
#include "editor/session/session.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <set>
#include <tuple>

namespace trivar {
namespace {

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

std::vector<int> numbers_of(const Points& points, const glm::ivec3& count)
{
    std::vector<int> out;
    for (const glm::ivec3& p : points) out.push_back(number_of(p, count));
    return out;
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

Points LatticePointsTool::chosen_points() const
{
    Points out;
    for (const int i : chosen_) out.push_back(point_of(i, of_));
    return out;
}

PointShift LatticePointsTool::shift_by_nothing() const
{
    return {.points = chosen_points(),
            .mirror = mirror_.y,
            .guard = guard_,
            .of = of_,
            .mirror_along = mirror_.x,
            .mirror_up = mirror_.z};
}

MotionFrame LatticePointsTool::frame_of(const Lattice& volume) const
{
    PointShift shift = shift_by_nothing();
    const VolumeDirections at = volume_directions(volume, greville(volume, shift.points.front()));
    if (proportional_) shift.weights.assign(chosen_.size(), 1);
    return {middle_of(volume, shift), glm::dmat3(at.along, at.across, at.up)};
}

MotionFrame LatticePointsTool::frame(const Session& session) const
{
    return frame_of(*selected_volume(session)->seen_cage());
}

double LatticePointsTool::radius(const Lattice& volume) const
{
    if (radius_m_ > 0) return radius_m_;
    constexpr double share = 0.5; // of the longest side as it was laid
    double longest = 0;
    for (int a = 0; a < 3; ++a)
        longest = std::max(longest, glm::length(glm::dvec3(volume.rest[a])));
    return rounded(share * longest, 2);
}

const EvaluatedObject* LatticePointsTool::seen(const Session& session) const
{
    return selected_volume(session);
}

void LatticePointsTool::look(const Session& session)
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) chosen_.clear();
    object_ = laid ? laid->id : 0;
    at_world_.clear();
    if (!laid) return;
    const glm::ivec3 n = point_count(laid->placement->volume);
    if (n != of_) chosen_ = numbers_of(within(chosen_points(), n), n);
    of_ = n;
    const Ref<Lattice> cage = laid->seen_cage();
    for (const glm::ivec3& p : all_points(n))
        at_world_.push_back(control_point(*cage, p.x, p.y, p.z));
}

std::optional<std::vector<std::string>> LatticePointsTool::numbers(const Session& session) const
{
    if (chosen_.empty() || object_ != session.selected) return {};
    const Points chosen = chosen_points();
    const std::vector<Ref<VolumeEdit>>& steps = object(session.document(), object_).shaping;
    for (std::size_t i = steps.size(); i-- > 0;)
        if (steps[i]->shift && are_alike(fully_held(*steps[i]->shift), chosen))
            return numbers_below(fmt::format("shaping.{}.shift", i));
    return std::vector<std::string>();
}

std::vector<int> LatticePointsTool::chosen_and_next() const
{
    return numbers_of(with_next(chosen_points(), of_), of_);
}

bool LatticePointsTool::resize(Session& session, double factor)
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || !proportional_) return false;
    radius_m_ = std::clamp(rounded(radius(laid->placement->volume) * factor, 3), 1e-6, 1e6);
    return true;
}

void LatticePointsTool::use(Session& session, const ViewportInput& input)
{
    tell(session);
    PointsTool::use(session, input);
}

void LatticePointsTool::choose_line(const Session& session)
{
    const ImGuiIO& io = ImGui::GetIO();
    const glm::ivec3 point = point_of(*hovered_, of_);
    const Ref<Lattice> cage = selected_volume(session)->seen_cage();
    const bool again = line_at_ == hovered_ && line_is_plane_ == io.KeyShift;
    line_axis_ = again ? (line_axis_ + 1) % 3
                       : clearest_axis(*cage, session.view.camera, point, io.KeyShift);
    line_at_ = hovered_;
    line_is_plane_ = io.KeyShift;
    if (!io.KeyCtrl) chosen_.clear();
    const Points line =
        line_is_plane_ ? plane_of(point, line_axis_, of_) : row_of(point, line_axis_, of_);
    for (const int each : numbers_of(line, of_))
        if (std::ranges::find(chosen_, each) == chosen_.end()) chosen_.push_back(each);
}

void LatticePointsTool::begin_motion(const Session& session)
{
    const Lattice& volume = selected_volume(session)->placement->volume;
    const glm::ivec3 first = point_of(chosen_.front(), of_);
    const Ref<Lattice> seen = selected_volume(session)->seen_cage();
    world_axes_ = frame_of(volume).axes;
    own_by_seen_ = own_by_seen(volume, *seen, first);
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
        const VolumeDirections at = volume_directions(before, greville(before, first));
        axes_ = glm::dmat3(at.along, at.across, at.up);
    }
    distances_ = by_distance(volume, shift_by_nothing());
    radius_m_ = radius(volume);
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
    PointShift out = shift_by_nothing();
    if (motion.kind == MotionKind::move) out.by = same ? motion.offset : along(motion.offset);
    // A hand moves what it sees; numbers are those of the volume itself.
    if (!gesture_->typed().open()) out.by *= own_by_seen_;
    if (motion.kind == MotionKind::scale) out.factors = motion.factors;
    if (motion.kind == MotionKind::rotate)
        out.rotation_deg = turn_of(motion, along(motion.turn_axis));
    if (!proportional_) return out;
    return with_neighbours(std::move(out), distances_, falloff_, radius_m_);
}

Command LatticePointsTool::wanted(const Session&)
{
    shown_ = shift();
    return MovePoints{object_, shown_};
}

void LatticePointsTool::tell(Session& session)
{
    if (told_of_ == 0 || gesture_ || !session.up_to_date()) return;
    const Shaping* last = last_shaping(session, std::exchange(told_of_, 0));
    if (last && last->would_fold)
        tell_where_it_stopped(session, *last, "The control points", "Move their neighbours too",
                              object_, held(session));
}

std::vector<VolumePart> LatticePointsTool::held(const Session& session) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) return {};
    const Lattice& volume = laid->placement->volume;
    const Points chosen = within(chosen_points(), point_count(volume));
    if (chosen.empty()) return {};
    return with_mirrored(bent_by(volume, chosen), mirror_.y);
}

} // namespace trivar
