// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/motion.h"

#include "core/commands/edits/edits.h"
#include "core/commands/objects/arrange.h"
#include "editor/session/selection.h"

#include <cmath>

namespace trivar {
namespace {

glm::dmat3 turned_about(const glm::dvec3& axis, double angle_deg)
{
    // Quarter turns are exact, and so four of them are none.
    const Transform quarter{.translation = {}, .rotation_deg = {0, 0, angle_deg}};
    const glm::dmat4 z = quarter.matrix();
    const double c = z[0][0], s = z[0][1];
    const glm::dvec3 a = axis;
    // Rodrigues: cos I + sin [a]x + (1 - cos) a a^T
    const glm::dmat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
    return glm::dmat3(c) + s * cross + (1 - c) * glm::outerProduct(a, a);
}

// Removes the noise of rounding from a number that was meant to be short.
double cleaned(double value)
{
    const double near = std::round(value * 1e6) / 1e6;
    return std::abs(value - near) < 1e-10 * std::max(1.0, std::abs(value)) ? near + 0.0 : value;
}
glm::dvec3 cleaned(const glm::dvec3& v)
{
    return {cleaned(v.x), cleaned(v.y), cleaned(v.z)};
}

glm::dvec3 with_origin_at(const Stand& stand, const glm::dvec3& p_world)
{
    if (p_world == stand.origin_world()) return stand.transform.translation;
    return cleaned(glm::dvec3(glm::inverse(stand.parent_to_world) * glm::dvec4(p_world, 1)));
}

Transform turned(const Stand& stand, const glm::dmat3& turn, const glm::dvec3& pivot)
{
    Transform result = stand.transform;
    const glm::dmat3 parent(stand.parent_to_world);
    const Transform rotation{.translation = {}, .rotation_deg = stand.transform.rotation_deg};
    const glm::dmat3 inside = glm::inverse(parent) * turn * parent * glm::dmat3(rotation.matrix());
    result.rotation_deg = cleaned(decomposed(glm::dmat4(inside)).rotation_deg);
    result.translation = with_origin_at(stand, pivot + turn * (stand.origin_world() - pivot));
    return result;
}

Transform scaled(const Stand& stand, const glm::dvec3& factors, const MotionFrame& frame)
{
    Transform result = stand.transform;
    const glm::dmat3 back = glm::transpose(frame.axes);
    const auto grow = [&](const glm::dvec3& v) { return frame.axes * (factors * (back * v)); };
    const Transform rotation{.translation = {}, .rotation_deg = stand.transform.rotation_deg};
    const glm::dmat3 own = glm::dmat3(stand.parent_to_world) * glm::dmat3(rotation.matrix());
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 grown = grow(own[k]);
        const double share = glm::length(grown) / glm::length(own[k]);
        result.scale[k] *= std::copysign(cleaned(share), glm::dot(grown, own[k]));
    }
    result.translation =
        with_origin_at(stand, frame.pivot + grow(stand.origin_world() - frame.pivot));
    return result;
}

} // namespace

bool Motion::is_nothing() const
{
    switch (kind) {
    case MotionKind::move: return offset == glm::dvec3(0);
    case MotionKind::rotate: return angle_deg == 0;
    default: return factors == glm::dvec3(1);
    }
}

glm::dvec3 Stand::origin_world() const
{
    return glm::dvec3(parent_to_world * glm::dvec4(transform.translation, 1));
}

glm::dmat3 Stand::axes_world() const
{
    const glm::dmat3 m(parent_to_world * transform.matrix());
    // A mirrored object's axes are still right-handed here: arrows do not flip with it.
    const glm::dvec3 x = glm::normalize(m[0] * std::copysign(1.0, transform.scale.x));
    const glm::dvec3 y = m[1] * std::copysign(1.0, transform.scale.y);
    const glm::dvec3 upright = glm::normalize(y - x * glm::dot(x, y));
    return {x, upright, glm::cross(x, upright)};
}

std::vector<Stand> stands_of(const Document& document, const std::vector<Id>& ids)
{
    std::vector<Stand> stands;
    for (const Id id : topmost(document, ids)) {
        const Object& each = object(document, id);
        if (each.stroke || locked(document, id)) continue;
        stands.push_back({id, each.transform,
                          each.parent == 0 ? glm::dmat4(1) : to_world(document, each.parent)});
    }
    return stands;
}

Transform moved(const Stand& stand, const Motion& motion, const MotionFrame& frame)
{
    if (motion.is_nothing()) return stand.transform;
    if (motion.kind == MotionKind::rotate)
        return turned(stand,
                      turned_about(glm::normalize(frame.axes * motion.turn_axis), motion.angle_deg),
                      frame.pivot);
    if (motion.kind == MotionKind::scale) return scaled(stand, motion.factors, frame);
    Transform result = stand.transform;
    const glm::dvec3 offset_world = frame.axes * motion.offset;
    result.translation = cleaned(result.translation +
                                 glm::inverse(glm::dmat3(stand.parent_to_world)) * offset_world);
    return result;
}

Command arranged(const std::vector<Id>& ids, const std::vector<Transform>& transforms)
{
    if (ids.size() == 1) return SetTransform{ids[0], transforms[0]};
    return Arrange{ids, transforms};
}

} // namespace trivar
