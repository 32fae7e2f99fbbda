// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incision_holds.h"

#include "core/base/rounded.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double incision_hold_px = 10;   // of a handle
constexpr double least_open_px = 13;      // so far from the cut stand the handles of a shut one
constexpr double least_deep_px = 30;      // and that of the depth
constexpr double zip_off_px = 24;         // so far beside the cut hangs the knot
constexpr double end_on = 0.35;           // share of its length below which a way is not followed
constexpr double depth_share = 0.3;       // of the length, where the handle of the depth stands
constexpr std::size_t fewest_points = 12; // of a stroke that a hand bends

std::optional<glm::dvec2> cut_pixel(const Camera& camera, const glm::dvec3& p_world)
{
    const PicturePoint at = project(camera, p_world);
    if (!(at.depth_world > 0)) return {};
    return at.p_px;
}

glm::dvec2 unit_or(const glm::dvec2& way, const glm::dvec2& other)
{
    const double length = glm::length(way);
    return length > 1e-6 ? way / length : other;
}

double world_per_px(const Camera& camera, const glm::dvec3& p_world)
{
    return pixel_size_world(camera, project(camera, p_world).depth_world);
}

// What of the width the lips are apart at a step, as a share, when it is quite open.
double full_share(const NamedIncision& incision, const SeenCut& seen)
{
    constexpr double least = 0.15; // nearer to an end a small drag would be a large opening
    const double x = static_cast<double>(seen.widest_at) / static_cast<double>(SeenCut::steps);
    IncisionOpening quite = incision.opening;
    quite.share = 1;
    return std::max(least, value_at(incision.cut.opening_profile, x) * share_at(quite, x)) *
           seen.widest;
}

double handy_length(double metres, bool snap)
{
    return rounded(metres, snap ? 1 : 3);
}

// The stroke with its points at places of the skin; those that have none stay.
std::vector<SurfacePoint> on_the_skin(const IncisedSkin& skin,
                                      const std::vector<SurfacePoint>& wanted,
                                      const std::vector<SurfacePoint>& before, double reach)
{
    const auto found = skin.seen(wanted, reach);
    std::vector<SurfacePoint> out = before;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (found[i]) out[i] = found[i]->at_rest;
    return out;
}

void move_end(const IncisionDrag& drag, const SurfacePoint& to, Incision& cut)
{
    std::vector<SurfacePoint> points = cut.stroke.size() < fewest_points
                                           ? at_equal_steps(cut.stroke, 2 * fewest_points)
                                           : cut.stroke;
    const bool start = drag.held.hold == IncisionHold::start;
    if (start) std::ranges::reverse(points);
    const glm::dvec3 way = to.p - points.back().p;
    std::vector<SurfacePoint> wanted;
    const double length = length_of(points);
    double along = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) along += glm::distance(points[i].p, points[i - 1].p);
        const double share = length > 0 ? along / length : 1;
        wanted.push_back({points[i].p + share * share * way, points[i].normal});
    }
    std::vector<SurfacePoint> moved =
        on_the_skin(drag.skin, wanted, points, glm::length(way) + 0.02 * drag.skin.diagonal());
    moved.front() = points.front();
    moved.back() = to;
    if (start) std::ranges::reverse(moved);
    cut.stroke = std::move(moved);
}

// The turn that takes one direction to another by the shortest way.
glm::dmat3 turn_between(const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), cosine = glm::dot(from, to);
    if (sine < 1e-9) return glm::dmat3(1);
    const glm::dvec3 k = axis / sine;
    const glm::dmat3 cross(0, k.z, -k.y, -k.z, 0, k.x, k.y, -k.x, 0);
    return glm::dmat3(1) + sine * cross + (1 - cosine) * cross * cross;
}

void move_all(const IncisionDrag& drag, const SurfacePoint& to, Incision& cut)
{
    const SurfacePoint& middle = drag.seen.line[SeenCut::steps / 2].at_rest;
    const glm::dmat3 turn = turn_between(middle.normal, to.normal);
    std::vector<SurfacePoint> wanted;
    for (const SurfacePoint& each : cut.stroke)
        wanted.push_back({to.p + turn * (each.p - middle.p), turn * each.normal});
    const auto found = drag.skin.seen(wanted, 0.5 * drag.seen.length);
    for (const auto& each : found)
        if (!each) return; // beyond an edge of the skin it stays where it was
    for (std::size_t i = 0; i < found.size(); ++i) cut.stroke[i] = found[i]->at_rest;
}

} // namespace

SurfacePoint handy(const SurfacePoint& point)
{
    SurfacePoint out;
    for (int i = 0; i < 3; ++i) {
        out.p[i] = rounded(point.p[i], 6);
        out.normal[i] = std::round(point.normal[i] * 1e5) / 1e5;
    }
    return out;
}

const CutEnd* end_near(const std::vector<CutEnd>& ends, const Camera& camera, glm::dvec2 p_px,
                       double within_px)
{
    const CutEnd* out = nullptr;
    for (const CutEnd& end : ends)
        if (const auto at = cut_pixel(camera, end.p_world))
            if (const double away = glm::distance(*at, p_px); away < within_px) {
                within_px = away;
                out = &end;
            }
    return out;
}

std::vector<IncisionHoldPoint> incision_holds(const NamedIncision& incision, const SeenCut& seen,
                                              const Camera& camera, double scale)
{
    std::vector<IncisionHoldPoint> out;
    if (seen.line.empty()) return out;
    const auto add = [&](IncisionHold hold, const glm::dvec3& base, const glm::dvec3& way_world,
                         double least_px, double metres, double per_metre) {
        const auto from = cut_pixel(camera, base);
        if (!from) return;
        IncisionHoldPoint point{hold, *from, *from, {0, 0}, 0};
        if (glm::length(way_world) > 0) {
            const double px = world_per_px(camera, base);
            const glm::dvec2 seen_way =
                project(camera, base + way_world * px).p_px - *from; // per pixel of length
            const bool hidden = glm::length(seen_way) < end_on;
            if (hidden && hold != IncisionHold::depth) return;
            // What points at the eye is drawn and dragged downward
            point.way_px = hidden ? glm::dvec2(0, 1) : glm::normalize(seen_way);
            const double shown = hidden ? 1 : glm::length(seen_way);
            point.metres_per_px = px / shown / seen.scale * per_metre;
            const double far_px = metres * seen.scale / px * shown;
            point.p_px += point.way_px * std::max(far_px, least_px * scale);
        }
        out.push_back(point);
    };
    const SurfaceHit& middle = seen.line[SeenCut::steps / 2];
    add(IncisionHold::place, middle.p_world, {}, 0, 0, 0);
    add(IncisionHold::start, seen.line.front().p_world, {}, 0, 0, 0);
    add(IncisionHold::end, seen.line.back().p_world, {}, 0, 0, 0);
    const std::size_t k = seen.widest_at;
    const double full = full_share(incision, seen) * incision.cut.width;
    const double half = full * incision.opening.share / 2;
    add(IncisionHold::open_left, seen.line[k].p_world, -seen.across[k], least_open_px, half,
        2 / full);
    add(IncisionHold::open_right, seen.line[k].p_world, seen.across[k], least_open_px, half,
        2 / full);
    const auto d = static_cast<std::size_t>(depth_share * static_cast<double>(SeenCut::steps));
    add(IncisionHold::depth, seen.line[d].p_world, -seen.line[d].normal_world, least_deep_px,
        incision.cut.depth, 1);
    // The knot hangs beside the cut, so that it never lies on an end
    const glm::dvec3 zip = seen.at(incision.opening.to);
    const auto step = std::min(
        static_cast<std::size_t>(incision.opening.to * static_cast<double>(SeenCut::steps)),
        SeenCut::steps);
    if (const auto at = cut_pixel(camera, zip)) {
        const auto right = cut_pixel(camera, zip + seen.across[step] * world_per_px(camera, zip));
        glm::dvec2 off = right ? unit_or(*right - *at, {0, -1}) : glm::dvec2(0, -1);
        if (off.y > 0) off = -off;
        out.push_back({IncisionHold::zip, *at + off * zip_off_px * scale, *at, off, 0});
    }
    return out;
}

std::optional<IncisionHoldPoint> incision_hold_at(const std::vector<IncisionHoldPoint>& points,
                                                  glm::dvec2 p_px, double scale)
{
    std::optional<IncisionHoldPoint> out;
    double nearest = incision_hold_px * scale;
    for (const IncisionHoldPoint& point : points)
        if (const double away = glm::distance(point.p_px, p_px); away < nearest) {
            nearest = away;
            out = point;
        }
    return out;
}

EditIncision dragged(const IncisionDrag& drag, glm::dvec2 to_px, bool snap)
{
    EditIncision out{drag.object, drag.number, drag.before};
    NamedIncision& to = out.incision;
    const double by = glm::dot(to_px - drag.from_px, drag.held.way_px) * drag.held.metres_per_px;
    const glm::dvec2 moved_px = drag.held.base_px + (to_px - drag.from_px);
    switch (drag.held.hold) {
    case IncisionHold::none: return out;
    case IncisionHold::start:
    case IncisionHold::end: {
        const CutEnd* other = end_near(drag.ends, drag.camera, moved_px, end_reach_px * drag.scale);
        if (other) {
            move_end(drag, other->at_rest, to.cut);
        } else {
            const auto hit = drag.skin.shut_hit(ray_through(drag.camera, moved_px));
            if (!hit) return out;
            move_end(drag, hit->at_rest, to.cut);
        }
        for (SurfacePoint& each : to.cut.stroke) each = handy(each);
        return out;
    }
    case IncisionHold::place: {
        const auto hit = drag.skin.shut_hit(ray_through(drag.camera, moved_px));
        if (!hit) return out;
        move_all(drag, hit->at_rest, to.cut);
        for (SurfacePoint& each : to.cut.stroke) each = handy(each);
        return out;
    }
    case IncisionHold::open_left:
    case IncisionHold::open_right: {
        const double share = std::max(0.0, drag.before.opening.share + by);
        to.opening.share = snap ? std::round(share * 20) / 20 : std::round(share * 1000) / 1000;
        if (share > 1) { // quite open: it becomes wider
            to.opening.share = 1;
            to.cut.width = handy_length(drag.before.cut.width * share, snap);
        }
        to.cut.stroke.clear();
        return out;
    }
    case IncisionHold::depth: {
        const double least = 0.02 * drag.before.cut.depth;
        to.cut.depth = handy_length(std::max(least, drag.before.cut.depth + by), snap);
        to.cut.stroke.clear();
        return out;
    }
    case IncisionHold::zip: {
        to.cut.stroke.clear();
        const auto near = near_cut(drag.seen, drag.camera, moved_px);
        if (!near) return out;
        to.opening.to =
            snap ? std::round(near->share * 20) / 20 : std::round(near->share * 1000) / 1000;
        return out;
    }
    }
    return out;
}

std::string words_of(IncisionHold hold, const NamedIncision& incision, const SeenCut& seen)
{
    const auto metres = [&](double on_model) {
        return ui::short_number(rounded(on_model * seen.scale, 3)) + " m";
    };
    switch (hold) {
    case IncisionHold::none: return "";
    case IncisionHold::start:
    case IncisionHold::end:
    case IncisionHold::place: return "Length " + metres(seen.length);
    case IncisionHold::open_left:
    case IncisionHold::open_right:
        return fmt::format("Opening {:.3g} %, {}", 100 * incision.opening.share,
                           metres(incision.opening.share * incision.cut.width * seen.widest));
    case IncisionHold::depth: {
        std::string words = "Depth " + metres(incision.cut.depth);
        if (seen.depth < 0.98 * incision.cut.depth) words += ", here at most " + metres(seen.depth);
        return words;
    }
    case IncisionHold::zip: return fmt::format("Open until {:.3g} %", 100 * incision.opening.to);
    }
    return "";
}

} // namespace trivar
