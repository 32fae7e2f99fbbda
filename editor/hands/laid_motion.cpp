// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/laid_motion.h"

#include "core/placement/view.h"
#include "core/steps/laying/attaching.h"
#include "editor/hands/selected_placement.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

constexpr double least_factor = 1e-3; // nothing is scaled to nothing

glm::dvec3 taken_by(const glm::dmat4& by, const glm::dvec3& p)
{
    return glm::dvec3(by * glm::dvec4(p, 1));
}

double scale_of(const glm::dmat4& to_world)
{
    return glm::length(glm::dvec3(to_world[0]));
}

EditPlacement with_stroke(const LaidStand& laid, const glm::dmat4& by, const Ground& above)
{
    EditPlacement edit{laid.object, laid.step.parameters, {}, {}};
    edit.sketch = moved_stroke(laid.step.sketch, by, *laid.scene, *laid.scene, above);
    edit.attach = laid.hosts;
    return edit;
}

// The clearance between scene and contact surface is measured toward the eye of the stroke: a lift
// along the normal takes more of it where the eye looks aslant, and shifts aside by so much.
struct Lift {
    double clearance = 0;
    glm::dvec3 aside{0}; // in the plane of the ground
};
Lift lifted_by(const LaidStand& laid, double distance)
{
    constexpr double least_cosine = 0.05; // where the eye hardly sees the ground
    const double was = laid.step.parameters.clearance;
    if (distance == 0) return {was};
    const glm::dvec3 up = -View(laid.step.sketch.camera).ray_to(laid.ground.p).direction;
    const double cosine = std::max(least_cosine, glm::dot(up, laid.ground.normal));
    const double clearance = std::max(0.0, was + distance / cosine);
    const glm::dvec3 aside = up - laid.ground.normal * glm::dot(up, laid.ground.normal);
    return {clearance, aside * (clearance - was)};
}

EditPlacement slid_to(const LaidStand& laid, const Ground& to)
{
    return with_stroke(laid, slid(laid.ground, to), to);
}

// A size that is in proportion to the model stays so where it grows as the length does.
void grow_size(double& size, double present, double factor, double length_factor)
{
    if (size > 0 || factor != length_factor) size = (size > 0 ? size : present) * factor;
}

EditPlacement grown_by_factors(const LaidStand& laid, const glm::dvec3& factors)
{
    const glm::dvec3 f = glm::max(glm::abs(factors), glm::dvec3(least_factor));
    EditPlacement edit = f.x == 1 ? EditPlacement{laid.object, laid.step.parameters, {}, {}}
                                  : with_stroke(laid, grown_on(laid.ground, f.x), laid.ground);
    grow_size(edit.parameters.width, laid.width, f.y, f.x);
    grow_size(edit.parameters.height, laid.height, f.z, f.x);
    edit.parameters.clearance *= f.z;
    return edit;
}

} // namespace

MotionFrame LaidStand::frame() const
{
    const glm::dmat3 turn = glm::dmat3(to_world) / scale_of(to_world);
    return {taken_by(to_world, ground.p),
            {turn * along, turn * glm::cross(ground.normal, along), turn * ground.normal}};
}

Stand LaidStand::stand() const
{
    const MotionFrame own = frame();
    glm::dmat4 matrix(own.axes);
    matrix[3] = glm::dvec4(own.pivot, 1);
    return {object, {}, matrix};
}

std::optional<LaidStand> laid_stand(const Session& session)
{
    const EvaluatedObject* laid = selected_placement(session);
    if (!laid || !laid->lies_on) return {};
    LaidStand out{laid->id, *object(session.document(), laid->id).stroke, laid->lies_on};
    if (out.step.round) return {};
    out.hosts = hosts_now(*laid, out.step);
    out.step.sketch = stroke_now(*laid, out.step);
    out.to_world = stroke_to_world(*laid);
    const glm::dmat4 from_world = glm::inverse(out.to_world);
    const PlacementReport& report = laid->stroke_placement()->report;
    const double scale = scale_of(from_world);
    out.width = report.width_world * scale;
    out.height = report.height_world * scale;
    out.reach = std::max(1e-9, std::min(out.width, report.length_world * scale) / 2);
    const PlacementParameters& p = out.step.parameters;
    const SurfaceJet<glm::dvec3> middle =
        evaluate(laid->stroke_placement()->contact, {p.start + p.fill / 2, 0.5}, 1);
    const glm::dmat3 turn = glm::dmat3(from_world) / scale;
    const glm::dvec3 normal = turn * glm::cross(middle.u, middle.v);
    if (!(glm::length(normal) > 0)) return {};
    const Ground lies{taken_by(from_world, middle.value), glm::normalize(normal)};
    // A body that spans a gap has the ground of its own surface.
    out.ground = ground_under(*out.scene, lies, out.reach + p.clearance).value_or(lies);
    const glm::dvec3 ahead = turn * middle.u;
    const glm::dvec3 along = ahead - out.ground.normal * glm::dot(ahead, out.ground.normal);
    if (!(glm::length(along) > 0)) return {};
    out.along = glm::normalize(along);
    return out;
}

std::optional<EditPlacement> moved(const LaidStand& laid, const Motion& motion,
                                   const MotionFrame& of)
{
    if (motion.kind == MotionKind::rotate)
        return with_stroke(laid, turned_on(laid.ground, motion.angle_deg), laid.ground);
    if (motion.kind == MotionKind::scale) return grown_by_factors(laid, motion.factors);
    const MotionFrame own = laid.frame();
    glm::dvec3 by = glm::transpose(own.axes) * (of.axes * motion.offset) / scale_of(laid.to_world);
    constexpr double rounding = 1e-12;
    if (std::abs(by.z) < rounding * glm::length(by)) by.z = 0; // a slide lifts nothing
    const glm::dvec3 left = glm::cross(laid.ground.normal, laid.along);
    const Lift lift = lifted_by(laid, by.z);
    const double distance = glm::length(glm::dvec2(by));
    glm::dmat4 motion_of_stroke(1);
    Ground to = laid.ground;
    if (distance > 0) {
        to =
            walked(*laid.scene, laid.ground, laid.along * by.x + left * by.y, distance, laid.reach);
        motion_of_stroke = slid(laid.ground, to);
    }
    // After what turns it on its way, so that a lift alone turns nothing.
    motion_of_stroke = motion_of_stroke * glm::translate(glm::dmat4(1), -lift.aside);
    EditPlacement edit{laid.object, laid.step.parameters, {}, {}};
    if (motion_of_stroke != glm::dmat4(1)) edit = with_stroke(laid, motion_of_stroke, to);
    edit.parameters.clearance = lift.clearance;
    return edit;
}

std::optional<EditPlacement> moved_under(const LaidStand& laid, const glm::dvec3& pivot_world,
                                         const Camera& camera)
{
    const Camera own = carried(camera, glm::inverse(laid.to_world));
    const Ray ray = View(own).ray(project(camera, pivot_world).p_px);
    const auto to = ground_hit(*laid.scene, ray, laid.reach);
    if (!to) return {};
    return slid_to(laid, *to);
}

} // namespace trivar
