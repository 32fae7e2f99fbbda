// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/split_holds.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/split.h"
#include "core/split/split_field.h"
#include "editor/hands/hand_motion.h"
#include "editor/tools/split/shown_cut.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double hold_reach_px = 9;    // of a hold
constexpr double outward_px = 17;      // how much further out the holds stand that are pulled out
constexpr double seen_end_on = 0.2;    // sine of the angle below which a way is not followed
constexpr double least_in_room = 0.02; // share of the room that a hold stays from its ends

Box box_in_frame(const SplitFrame& frame, const Box& world)
{
    Box out;
    for (const glm::dvec3& corner : world.corners()) out.add(frame.uvw(corner));
    return out;
}

// The middle of what both ranges have in common, or of the first one.
double common_middle(double lo, double hi, double other_lo, double other_hi)
{
    const double from = std::max(lo, other_lo), to = std::min(hi, other_hi);
    if (from < to) return (from + to) / 2;
    const double margin = least_in_room * (hi - lo);
    return std::clamp(other_lo, lo + margin, hi - margin);
}

// Four digits, as drags of numbers give; in round steps two.
double handy_metres(double value, bool snap)
{
    return rounded(std::max(0.0, value), snap ? 2 : 4);
}

} // namespace

std::vector<SplitHoldPoint> split_holds(const Document& document, const EvaluatedObject& object)
{
    std::vector<SplitHoldPoint> out;
    if (!object.split_field || object.bounds->empty()) return out;
    const SplitField& field = *object.split_field;
    const Box there = box_in_frame(field.frame, *object.bounds);
    const glm::dvec3 u = field.frame.axes[0], w = field.frame.axes[2];
    for (std::size_t i = 0; i < field.openings.size(); ++i) {
        const Opening& opening = field.openings[i];
        const glm::dvec2 lo = opening.walls[0].lo(), hi = opening.walls[0].hi();
        const glm::dvec2 vw((lo.x + hi.x) / 2, common_middle(lo.y, hi.y, there.lo.z, there.hi.z));
        const double phi = opening.surface_cells.value(vw);
        const auto at = [&](double beyond) { return field.frame.world({phi + beyond, vw}); };
        SplitHoldPoint point;
        point.base_world = point.p_world = at(0);
        point.obstacles.assign(opening.objects.begin(), opening.objects.end());
        const auto number = static_cast<int>(i);
        if (!stands_of(document, point.obstacles).empty()) {
            point.hold = {SplitHoldKind::place, number, 0};
            point.way = field.frame.axes[1];
            point.across = w;
            out.push_back(point);
        }
        point.across = glm::dvec3(0);
        for (const int side : {-1, 1}) {
            const std::size_t s = side > 0 ? 1 : 0;
            point.way = static_cast<double>(side) * u;
            const double open = opening.wall_cells[s].value(vw);
            point.hold = {SplitHoldKind::clearance, number, side};
            point.p_world = at(side * open);
            if (const auto& splitting = trivar::object(document, object.id).splitting)
                for (const ObstacleUse& use : splitting->obstacles)
                    if (std::ranges::find(point.obstacles, use.object) != point.obstacles.end())
                        point.value = std::max(point.value, use.clearance);
            out.push_back(point);
            point.hold.kind = SplitHoldKind::reach;
            point.p_world = at(side * opening.reach[s]);
            point.value = opening.reach[s];
            point.least = needed_reach(opening, s, opening.kernel);
            out.push_back(point);
            point.value = point.least = 0;
        }
    }
    return out;
}

std::vector<SplitHoldPoint> cut_holds(const Cutting& cutting, const EvaluatedObject& object)
{
    std::vector<SplitHoldPoint> out;
    if (object.bounds->empty()) return out;
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(object.own_to_world)));
    for (std::size_t i = 0; i < cutting.cuts.size(); ++i) {
        const PlainCut& cut = cutting.cuts[i];
        if (!cut.cuts()) continue;
        const ShownCut shown = shown_cut(cutting, i, object);
        SplitHoldPoint point;
        point.hold = {SplitHoldKind::level, static_cast<int>(i), 0};
        point.way = glm::normalize(normals * glm::normalize(cut.normal));
        point.base_world = point.p_world = shown.middle;
        out.push_back(point);
        if (cut.keep != CutKeep::both) continue;
        const glm::dvec3 up = point.way;
        for (const int side : {-1, 1}) {
            point.hold = {SplitHoldKind::gap, static_cast<int>(i), side};
            point.way = static_cast<double>(side) * up;
            point.p_world = shown.faces[side > 0 ? 1 : 0];
            point.value = cut.gap;
            out.push_back(point);
        }
    }
    return out;
}

std::optional<glm::dvec2> seen_at(const SplitHoldPoint& point, const Camera& camera, double scale)
{
    const PicturePoint at = project(camera, point.p_world);
    if (!(at.depth_world > 0)) return std::nullopt;
    const SplitHoldKind kind = point.hold.kind;
    if (kind == SplitHoldKind::place) return at.p_px;
    // The way as it is seen, per metre, against a way across the picture
    const double pixel = pixel_size_world(camera, at.depth_world);
    const glm::dvec2 way = (project(camera, point.p_world + point.way * pixel).p_px - at.p_px);
    if (!(glm::length(way) > seen_end_on)) return std::nullopt;
    if (kind == SplitHoldKind::clearance || kind == SplitHoldKind::level) return at.p_px;
    return at.p_px + glm::normalize(way) * outward_px * scale;
}

std::optional<SplitHoldPoint> hold_at(const std::vector<SplitHoldPoint>& points,
                                      const Camera& camera, glm::dvec2 p_px, double scale)
{
    std::optional<SplitHoldPoint> out;
    double nearest = hold_reach_px * scale;
    for (const SplitHoldPoint& point : points)
        if (const auto at = seen_at(point, camera, scale))
            if (const double d = glm::distance(*at, p_px); d < nearest) {
                nearest = d;
                out = point;
            }
    return out;
}

Command dragged(const SplitHoldDrag& drag, glm::dvec2 to_px, bool snap)
{
    const SplitHoldPoint& held = drag.held;
    const auto number = static_cast<std::size_t>(held.hold.number);
    if (held.hold.kind == SplitHoldKind::place) {
        glm::dvec3 by =
            dragged_in_plane(drag.camera, held.p_world, held.across, drag.from_px, to_px);
        if (snap) by = glm::round(by * 10.0) / 10.0;
        std::vector<Id> ids;
        std::vector<Transform> transforms;
        for (const Stand& stand : drag.obstacles) {
            ids.push_back(stand.id);
            transforms.push_back(moved(stand, {.offset = by}, {stand.origin_world()}));
        }
        return arranged(ids, transforms);
    }
    const double by = dragged_along(drag.camera, held.p_world, held.way, drag.from_px, to_px);
    if (held.hold.kind == SplitHoldKind::level || held.hold.kind == SplitHoldKind::gap) {
        Cutting cutting = drag.cutting;
        if (number >= cutting.cuts.size()) // it was only proposed
            return CutThrough{{drag.object}, std::move(cutting)};
        PlainCut& cut = cutting.cuts[number];
        if (held.hold.kind == SplitHoldKind::gap) {
            cut.gap = handy_metres(held.value + 2 * by, snap);
        } else {
            const double step = snap ? std::round(by * 10) / 10 : by;
            // By its normal alone: the plane stays parallel whatever the object's scale
            const glm::dvec3 way = glm::inverse(glm::dmat3(drag.own_to_world)) * (held.way * step);
            const glm::dvec3 n = glm::normalize(cut.normal);
            cut.point += n * glm::dot(n, way);
            for (int i = 0; i < 3; ++i) cut.point[i] = rounded(cut.point[i], 9);
        }
        return CutThrough{{drag.object}, std::move(cutting)};
    }
    Splitting splitting = drag.splitting;
    for (ObstacleUse& use : splitting.obstacles) {
        if (std::ranges::find(held.obstacles, use.object) == held.obstacles.end()) continue;
        const double value = handy_metres(held.value + by, snap);
        if (held.hold.kind == SplitHoldKind::clearance)
            use.clearance = value;
        else
            use.reach = value > held.least ? value : 0; // 0: as far as it needs
    }
    return Split{{drag.object}, std::move(splitting)};
}

std::string words_of(const SplitHoldPoint& point)
{
    switch (point.hold.kind) {
    case SplitHoldKind::none: return "";
    case SplitHoldKind::place: return "Obstacle";
    case SplitHoldKind::level: return "Place of the cut";
    case SplitHoldKind::gap: return fmt::format("Gap {} m", number_text(point.value));
    case SplitHoldKind::clearance: return fmt::format("Clearance {} m", number_text(point.value));
    case SplitHoldKind::reach:
        return fmt::format("Reach {} m{}", number_text(point.value),
                           point.value > point.least * 1.0001 ? "" : ", the least");
    }
    return "";
}

} // namespace trivar
