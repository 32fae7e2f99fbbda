// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/transform_gesture.h"

#include "editor/hands/hand_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivar {
namespace {

const Stand& active_of(const std::vector<Stand>& stands, Id active)
{
    for (const Stand& stand : stands)
        if (stand.id == active) return stand;
    return stands.back();
}

Measure measure_of(MotionKind kind)
{
    return kind == MotionKind::move     ? Measure::length
           : kind == MotionKind::rotate ? Measure::angle
                                        : Measure::plain;
}

glm::dvec3 factors_along(const GizmoHandle& constraint, double factor)
{
    glm::dvec3 factors(constraint.grip == Grip::axis ? 1 : factor);
    if (constraint.grip == Grip::axis) factors[constraint.axis] = factor;
    if (constraint.grip == Grip::plane) factors[constraint.axis] = 1;
    return factors;
}

} // namespace

glm::dvec3 pivot_of(const std::vector<Stand>& stands, Id active, Pivot pivot, const Box& seen_world)
{
    if (pivot == Pivot::each || pivot == Pivot::active)
        return active_of(stands, active).origin_world();
    if (pivot == Pivot::center && !seen_world.empty()) return seen_world.center();
    glm::dvec3 middle{0};
    for (const Stand& stand : stands)
        middle += stand.origin_world() / static_cast<double>(stands.size());
    return middle;
}

glm::dmat3 shared_axes(const std::vector<Stand>& stands, Id active, Orientation orientation,
                       const Camera& camera)
{
    if (orientation == Orientation::view) return view_axes(camera);
    return orientation == Orientation::local ? active_of(stands, active).axes_world()
                                             : glm::dmat3(1);
}

TransformGesture::TransformGesture(MotionKind kind, std::vector<Stand> stands, Id active,
                                   const TransformChoices& choices, const Camera& camera,
                                   const Grasp& grasp)
    : kind_(kind),
      stands_(std::move(stands)),
      active_(active),
      choices_(choices),
      asked_(choices.orientation),
      camera_(camera),
      pivot_world_(grasp.pivot_world),
      constraint_(grasp.handle),
      by_handle_(grasp.handle.grip != Grip::none),
      own_axes_(grasp.own_axes),
      scale_(grasp.scale),
      from_px_(grasp.from_px),
      hand_px_(grasp.from_px),
      mouse_px_(grasp.from_px)
{
    const Grip grip = grasp.handle.grip;
    if (grip == Grip::center || grip == Grip::view_ring) constraint_ = {};
}

bool TransformGesture::about_view() const
{
    return kind_ == MotionKind::rotate && constraint_.grip == Grip::none;
}

MotionFrame TransformGesture::frame() const
{
    const Orientation whose = about_view() ? Orientation::view : choices_.orientation;
    return {pivot_world_, shared_axes(stands_, active_, whose, camera_)};
}

glm::dvec3 TransformGesture::turn_axis_world() const
{
    return frame().axes[about_view() ? 2 : constraint_.axis];
}

void TransformGesture::move_hand(const Camera& camera, glm::dvec2 to_px, HeldKeys held)
{
    const glm::dvec2 from = std::exchange(mouse_px_, to_px);
    held_ = held;
    if (camera != camera_) { // what was done stays, and the hand begins anew from here
        offset_before_ = offset_by_hand();
        factor_before_ = factor_by_hand();
        camera_ = camera;
        from_px_ = hand_px_ = to_px;
        return;
    }
    if (to_px == from) return;
    const double speed = held.fine ? 0.1 : 1;
    hand_px_ += (to_px - from) * speed;
    travelled_px_ = std::max(travelled_px_, glm::distance(to_px, from_px_));
    // Round the pivot it is the angle that goes slower: a slow hand would lose the circle.
    if (kind_ == MotionKind::rotate) turned_deg_ += speed * turned_deg(from, to_px);
}

void TransformGesture::choose_axis(int axis, bool plane)
{
    const GizmoHandle wanted{plane                         ? Grip::plane
                             : kind_ == MotionKind::rotate ? Grip::ring
                                                           : Grip::axis,
                             axis};
    // There is no turning in a line.
    if (kind_ == MotionKind::rotate && (plane || own_axes_)) return;
    by_handle_ = false;
    typed_.begin_anew();
    const auto away = [&] {
        return glm::dot(turn_axis_world(), toward_eye(camera_, frame().pivot)) < 0;
    };
    const bool before = away();
    const Orientation other =
        choices_.orientation == Orientation::local ? Orientation::world : Orientation::local;
    if (constraint_ != wanted) {
        constraint_ = wanted;
        asked_ = choices_.orientation;
    } else if (choices_.orientation == asked_ && !own_axes_) {
        choices_.orientation = other;
    } else {
        constraint_ = {};
        choices_.orientation = asked_;
    }
    if (away() != before) turned_deg_ = -turned_deg_; // it still turns as the mouse goes round
}

double TransformGesture::snapped(double amount) const
{
    if (!held_.snap) return amount;
    const double step = choices_.step(kind_) * (held_.fine ? 0.1 : 1);
    return step > 0 ? std::round(amount / step) * step : amount;
}

std::vector<int> TransformGesture::named_axes() const
{
    const int axis = constraint_.axis;
    switch (constraint_.grip) {
    case Grip::axis:
    case Grip::ring: return {axis};
    case Grip::plane:
        if (kind_ != MotionKind::move) return {(axis + 1) % 3};
        return axis == 1 ? std::vector<int>{0, 2}
                         : std::vector<int>{(axis + 1) % 3, (axis + 2) % 3};
    default: return kind_ == MotionKind::move ? std::vector<int>{0, 1, 2} : std::vector<int>{0};
    }
}

glm::dvec3 TransformGesture::offset_by_hand() const
{
    const MotionFrame f = frame();
    const glm::dvec3 axis = f.axes[constraint_.axis];
    const double before = glm::dot(axis, offset_before_);
    if (constraint_.grip == Grip::axis)
        return axis * (before + dragged_along(camera_, f.pivot, axis, from_px_, hand_px_));
    if (constraint_.grip == Grip::plane)
        return offset_before_ - axis * before +
               dragged_in_plane(camera_, f.pivot, axis, from_px_, hand_px_);
    return offset_before_ + dragged_across(camera_, f.pivot, from_px_, hand_px_);
}

double TransformGesture::factor_by_hand() const
{
    return factor_before_ * grown_by(camera_, frame().pivot, 100 * scale_, from_px_, hand_px_);
}

double TransformGesture::turned_deg(glm::dvec2 from_px, glm::dvec2 to_px) const
{
    const glm::dvec3 pivot = frame().pivot, about = turn_axis_world();
    if (!by_handle_ || constraint_.grip != Grip::ring)
        return swept_deg(camera_, pivot, about, from_px, to_px);
    constexpr double edge_on = 0.35; // twenty degrees
    if (std::abs(glm::dot(about, toward_eye(camera_, pivot))) < edge_on)
        return rolled_deg(camera_, about, ring_radius_px * scale_, from_px, to_px);
    return followed_deg(camera_, pivot, about, from_px, to_px);
}

Motion TransformGesture::by_hand() const
{
    Motion m{.kind = kind_};
    const int axis = constraint_.axis;
    const Grip grip = constraint_.grip;
    if (kind_ == MotionKind::move) {
        m.offset = glm::transpose(frame().axes) * offset_by_hand();
        for (int i = 0; i < 3; ++i) {
            const bool free = grip == Grip::none || (grip == Grip::axis) == (i == axis);
            m.offset[i] = free ? snapped(m.offset[i]) : 0;
        }
        // Across the picture level: what is left of the height is the noise of a sum.
        const glm::dvec3 size = glm::abs(m.offset);
        const double least = 1e-12 * std::max({size.x, size.y, size.z});
        for (int i = 0; i < 3; ++i)
            if (size[i] < least) m.offset[i] = 0;
    } else if (kind_ == MotionKind::rotate) {
        m.turn_axis = glm::dvec3(0);
        m.turn_axis[about_view() ? 2 : axis] = 1;
        m.angle_deg = snapped(turned_deg_);
    } else {
        constexpr double least = 1e-3; // nothing is scaled to nothing
        double factor = snapped(factor_by_hand());
        if (std::abs(factor) < least)
            factor = std::copysign(held_.snap ? choices_.step_factor : least, factor);
        m.factors = factors_along(constraint_, factor);
    }
    return m;
}

Motion TransformGesture::by_numbers() const
{
    Motion m = by_hand();
    const Measure measure = measure_of(kind_);
    if (kind_ == MotionKind::rotate) {
        m.angle_deg = typed_.value(0, measure).value_or(0);
    } else if (kind_ == MotionKind::scale) {
        const double typed = typed_.value(0, measure).value_or(1);
        m.factors = factors_along(constraint_, typed == 0 ? 1 : typed);
    } else {
        m.offset = glm::dvec3(0);
        const std::vector<int> axes = named_axes();
        for (std::size_t i = 0; i < axes.size(); ++i)
            m.offset[axes[i]] = typed_.value(static_cast<int>(i), measure).value_or(0);
    }
    return m;
}

bool TransformGesture::free() const
{
    return constraint_.grip == Grip::none && !typed_.open();
}

Motion TransformGesture::motion() const
{
    return typed_.open() ? by_numbers() : by_hand();
}

std::vector<Id> TransformGesture::ids() const
{
    std::vector<Id> ids;
    for (const Stand& stand : stands_) ids.push_back(stand.id);
    return ids;
}

std::vector<Transform> TransformGesture::transforms() const
{
    const Motion m = motion();
    const MotionFrame common = frame();
    std::vector<Transform> result;
    for (const Stand& stand : stands_) {
        MotionFrame own = common;
        if (choices_.pivot == Pivot::each) own.pivot = stand.origin_world();
        if (choices_.orientation == Orientation::local && !about_view())
            own.axes = stand.axes_world();
        result.push_back(moved(stand, m, own));
    }
    return result;
}

} // namespace trivar
