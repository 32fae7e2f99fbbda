// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/placement/placement.h"

#include "core/base/rejected.h"
#include "core/placement/contact.h"
#include "core/placement/finish.h"
#include "core/placement/height_map.h"
#include "core/placement/layout.h"
#include "core/placement/lift.h"
#include "core/placement/profile.h"
#include "core/placement/sharp.h"
#include "core/placement/volume.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Throws Rejected if the volume reaches the camera, where perspective would turn it inside out.
void check_reach(const Surface<glm::dvec3>& contact, const View& view, double height)
{
    if (!view.perspective()) return;
    for (const glm::dvec3& p : contact.points)
        if (height > 0.9 * view.project(p).depth_world)
            throw Rejected(fmt::format("a volume {} m high would reach the camera; move the "
                                       "camera back or reduce the height",
                                       number_text(height)));
}

bool pierced(const PlacementReport& r, const PlacementParameters& p)
{
    return r.penetration > p.lift_tolerance;
}

constexpr double far_off = 0.5; // share of the length: a longer gap is not bridged

std::vector<std::string> notices(const PlacementReport& r, const Extrusion& e,
                                 const PlacementParameters& p, const std::vector<DepthJump>& jumps)
{
    std::vector<std::string> out;
    if (r.missed_share > 0)
        out.push_back(percent_text(std::max(0.01, r.missed_share)) +
                      " of the model has no surface beneath it");
    constexpr double at_end = 0.01;
    if (!jumps.empty() && std::abs(deepest(jumps).at - 0.5) > 0.5 - at_end)
        out.emplace_back("it reaches over the edge of the surface at an end of the stroke");
    else if (!jumps.empty())
        out.push_back(fmt::format("the surface ends {} along the stroke; the model spans the gap",
                                  percent_text(deepest(jumps).at)));
    else if (p.springs && r.largest_gap > far_off * r.length_world)
        out.push_back(fmt::format("it hovers up to {} m above the surface; lower the "
                                  "stiffness, or let it drop into gaps",
                                  number_text(r.largest_gap, {.digits = 2})));
    const auto some = [](int count, const char* one, const char* more) {
        return count == 1 ? std::string(one) : fmt::format("{} {}", count, more);
    };
    if (r.narrowed > 0)
        out.push_back(fmt::format("the turn is too tight for this width, so the model is pinched "
                                  "in {}; draw a wider turn or reduce the width",
                                  some(r.narrowed, "one place", "places")));
    if (e.lowered > 0)
        out.push_back(fmt::format("the volume would fold and is lowered to less than half in {}; "
                                  "reduce the height or the offset",
                                  some(e.lowered, "one place", "places")));
    // If both occur, more control points help against one and worsen the other.
    if (pierced(r, p)) {
        out.push_back(fmt::format("{} of the height still penetrates the surface{}",
                                  percent_text(r.penetration),
                                  r.folds.empty() ? "; use more control points" : ""));
    }
    return out;
}

std::vector<StripNode> nodes_of(const StripLayout& layout, const Surface<glm::dvec3>& contact,
                                const Extrusion& e, const PlacementParameters& parameters)
{
    const Profile width(parameters.width_profile);
    const int rows = contact.axes[0].count(), columns = contact.axes[1].count();
    std::vector<StripNode> out;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const std::size_t k = out.size();
            const glm::dvec2 uv(contact.axes[0].greville(i), contact.axes[1].greville(j));
            const double asked = layout.length * layout.width * width.at(uv.x);
            out.push_back({evaluate(contact, uv).value,
                           !layout.grid.hit[k] ? Contact::missed
                           : layout.touches(k) ? Contact::touches
                                               : Contact::bridges,
                           e.area[k] / asked, !(e.det[k] > 0)});
        }
    return out;
}

} // namespace

std::vector<std::vector<glm::dvec3>> outline(const Surface<glm::dvec3>& contact)
{
    std::vector<std::vector<glm::dvec3>> out;
    const int count = 2 * contact.axes[0].count();
    for (const double v : {0.5, 0.0, 1.0}) {
        out.emplace_back();
        for (int i = 0; i <= count; ++i)
            out.back().push_back(evaluate(contact, {static_cast<double>(i) / count, v}).value);
    }
    return out;
}

Placement finished(const StripLayout& layout, const std::vector<double>& s, const Camera& camera,
                   const PlacementParameters& parameters, const ModelFrame& frame,
                   const RayScene& scene, Timings& timings)
{
    std::vector<glm::dvec3> points(s.size());
    for (std::size_t k = 0; k < s.size(); ++k) points[k] = layout.sheet.point(k, s);
    const bool through_nodes = !jumps(layout.axes, points, layout.sheet.direction);
    const LiftedSurface lift = timed(timings, "lift", [&] {
        Surface<glm::dvec3> surface = contact_surface(layout.axes, points, through_nodes);
        if (!layout.features.empty())
            surface =
                drawn_to(std::move(surface), View(camera), layout.features, parameters.clearance);
        return lifted(std::move(surface), camera, scene,
                      {.tolerance = parameters.lift_tolerance * layout.height,
                       .clearance = parameters.clearance,
                       .skip_back_faces = parameters.skip_back_faces,
                       .never_overshoot = !through_nodes});
    });
    const Surface<glm::dvec3>& contact = lift.contact;
    return timed(timings, "volume", [&] {
        const View view(camera);
        const Profile along(parameters.height_profile), across(parameters.height_across);
        const HeightMap map(parameters.height_map);
        const Knots above = Knots::uniform(parameters.orders.z, parameters.grid.z);
        const Rise rise(parameters.rise_profile, above);
        const double level = parameters.contact_level;
        const Levels levels = levels_of(rise, level);
        check_reach(contact, view,
                    levels.roof * across.largest() * along.largest() * map.largest() *
                        layout.height);
        std::vector<double> heights;
        for (int i = 0; i < contact.axes[0].count(); ++i) {
            const double u = contact.axes[0].greville(i), row = layout.height * along.at(u);
            for (int j = 0; j < contact.axes[1].count(); ++j) {
                const double v = contact.axes[1].greville(j);
                heights.push_back(row * across.at(v) * map.at(u, v));
            }
        }
        const Extrusion e =
            extrusion(contact, view, heights, parameters.offset, through_nodes, levels);
        Placement out{contact,
                      volume_over(contact, e.rise, above, rise, level),
                      {},
                      {},
                      outline(contact),
                      0,
                      level,
                      {}};
        out.embedding.to_uvw = model_to_uvw(frame, parameters);
        out.embedding.to_rest = out.volume.rest * out.embedding.to_uvw;
        PlacementReport& r = out.report;
        r.length_world = layout.length;
        r.width_world = layout.width;
        r.height_world = layout.height;
        r.missed_share = layout.grid.missed_share();
        r.contact_share = layout.contact_share;
        r.largest_gap = lift.largest_gap;
        r.penetration = lift.penetration / layout.height;
        r.largest_stretch = e.longest_u / layout.length;
        r.spring_iterations = layout.spring_iterations;
        r.narrowed = layout.narrowed;
        r.smallest_jacobian = e.least_det() / (layout.length * layout.width * layout.height);
        if (!(r.smallest_jacobian > 0))
            r.folds = fmt::format("the volume folds; use {}a wider turn or less height",
                                  pierced(r, parameters) ? "" : "fewer control points, ");
        r.notices = notices(r, e, parameters, layout.jumps);
        out.node_columns = contact.axes[1].count();
        out.nodes = nodes_of(layout, contact, e, parameters);
        return out;
    });
}

std::vector<std::string> PlacementReport::all_notices() const
{
    std::vector<std::string> all = notices;
    if (!folds.empty()) all.push_back(folds);
    return all;
}

namespace {

constexpr double most_stretch = 4;  // of a strip that goes down a cliff
constexpr double most_folds = 0.05; // of the nodes: so few can be repaired

// Whether the volume is torn, as by surfaces of different depth.
bool torn(const PlacementReport& r)
{
    return !r.folds.empty() || r.largest_stretch > most_stretch ||
           r.largest_gap > far_off * r.length_world;
}

// The same stroke on one surface; nothing where it passes no edge.
std::optional<Placement> bridged(const Sketch& sketch, PlacementParameters parameters,
                                 const ModelFrame& frame, const RayScene& scene, Timings& timings)
{
    parameters.sharp = false;
    const StripLayout layout = lay_out(sketch, parameters, frame, scene, timings, Jumps::bridged);
    if (layout.jumps.empty()) return {};
    return finished(layout, layout.s, sketch.camera, parameters, frame, scene, timings);
}

// Whether the placement on one surface is sound, or at least folds less than the one that follows
// the jumps.
bool better(const Placement& on_one, const Placement& followed)
{
    const auto folds = [](const Placement& p) {
        return static_cast<double>(std::ranges::count(p.nodes, true, &StripNode::folds));
    };
    const bool stands = folds(on_one) <= most_folds * static_cast<double>(on_one.nodes.size()) &&
                        on_one.report.largest_stretch <= 2 * most_stretch;
    return stands || folds(on_one) < folds(followed);
}

} // namespace

Placement place(const Sketch& sketch, const PlacementParameters& parameters, const Box& model,
                const RayScene& scene, Timings& timings)
{
    const ModelFrame frame = model_frame(parameters, model);
    std::optional<Placement> followed;
    try {
        const StripLayout layout = lay_out(sketch, parameters, frame, scene, timings);
        followed = finished(layout, layout.s, sketch.camera, parameters, frame, scene, timings);
    } catch (const Rejected&) { // a way down and up again makes it too long, wide or high
        if (!parameters.bridge_jumps) throw;
        if (auto on_one = bridged(sketch, parameters, frame, scene, timings))
            return std::move(*on_one);
        throw;
    }
    Placement& out = *followed;
    if (parameters.bridge_jumps && torn(out.report))
        if (auto on_one = bridged(sketch, parameters, frame, scene, timings);
            on_one && better(*on_one, out))
            return std::move(*on_one);
    if (!parameters.sharp) return std::move(out);
    // Not every sharp edge can be followed: if the volume would pierce the scene or fold, edges are
    // rounded.
    const auto stands = [&](const PlacementReport& r) {
        return !pierced(r, parameters) && r.smallest_jacobian > 0;
    };
    if (stands(out.report)) return std::move(out);
    PlacementParameters round = parameters;
    round.sharp = false;
    Placement rounded = place(sketch, round, model, scene, timings);
    if (!stands(rounded.report) && rounded.report.smallest_jacobian < out.report.smallest_jacobian)
        return std::move(out);
    rounded.report.notices.emplace_back(
        "the edges beneath it are too sharp to follow, so they are rounded");
    return rounded;
}

} // namespace trivar
