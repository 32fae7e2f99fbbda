// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_holds.h"

#include "core/base/number_text.h"
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
constexpr double opening_end_on = 0.35;   // share of its length below which a way is not followed
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

// The first of some steps that is on the longest part on the skin and away from where others cross;
// the first one that is on it where none is.
std::size_t step_away_from(const SeenCut& seen, std::span<const double> crossed,
                           std::initializer_list<std::size_t> steps)
{
    constexpr double apart = 0.09;
    const auto on_part = [&](std::size_t step) { return std::clamp(step, seen.first, seen.last); };
    for (const std::size_t step : steps) {
        const double share = static_cast<double>(step) / static_cast<double>(SeenCut::steps);
        if (step == on_part(step) && std::ranges::none_of(crossed, [&](double each) {
                return std::abs(each - share) < apart;
            }))
            return step;
    }
    return on_part(*steps.begin());
}

// Where the handles of the opening stand: where it is widest, or about there.
std::size_t step_of_opening(const SeenCut& seen, std::span<const double> crossed)
{
    constexpr std::size_t off = 8, least = 10;
    const std::size_t k = seen.widest_at;
    if (k < least || k + least > SeenCut::steps) return k;
    return step_away_from(seen, crossed, {k, k - off, k + off, k - least, k + least});
}

// Returns the distance of the lips at a step when it is fully open, as a share of the width.
double full_share(const NamedIncision& incision, const SeenCut& seen, std::size_t step)
{
    constexpr double least = 0.15; // nearer to an end a small drag would be a large opening
    const double x = static_cast<double>(step) / static_cast<double>(SeenCut::steps);
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

std::optional<std::vector<SurfacePoint>> moved_over(const IncisedSkin& skin,
                                                    const std::vector<SurfacePoint>& stroke,
                                                    const SurfacePoint& from,
                                                    const SurfacePoint& to, double reach)
{
    const glm::dmat3 turn = turn_between(from.normal, to.normal);
    std::vector<SurfacePoint> wanted;
    for (const SurfacePoint& each : stroke)
        wanted.push_back({to.p + turn * (each.p - from.p), turn * each.normal});
    const auto found = skin.seen(wanted, reach);
    std::vector<SurfacePoint> out;
    for (const auto& each : found) {
        if (!each) return {};
        out.push_back(handy(each->at_rest));
    }
    return out;
}

std::vector<IncisionHoldPoint> incision_holds(const NamedIncision& incision, const SeenCut& seen,
                                              const Camera& camera, double scale,
                                              std::span<const double> crossed)
{
    std::vector<IncisionHoldPoint> out;
    const auto add = [&](IncisionHold hold, std::size_t step, const glm::dvec3& way_world,
                         double least_px, double metres, double per_metre) {
        const glm::dvec3& base = seen.line[step].p_world;
        const auto from = cut_pixel(camera, base);
        if (!from) return;
        IncisionHoldPoint point{hold, *from, *from};
        point.share = static_cast<double>(step) / static_cast<double>(SeenCut::steps);
        if (glm::length(way_world) > 0) {
            const double px = world_per_px(camera, base);
            const glm::dvec2 seen_way =
                project(camera, base + way_world * px).p_px - *from; // per pixel of length
            const bool hidden = glm::length(seen_way) < opening_end_on;
            if (hidden && hold != IncisionHold::depth) return;
            // A handle that points at the eye is drawn and dragged downward, or to the right beside
            // a cut that goes down itself
            const glm::dvec2 along =
                project(camera, seen.line[std::min(step + 2, SeenCut::steps)].p_world).p_px -
                project(camera, seen.line[step > 2 ? step - 2 : 0].p_world).p_px;
            const glm::dvec2 beside =
                std::abs(along.y) > std::abs(along.x) ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
            point.way_px = hidden ? beside : glm::normalize(seen_way);
            const double shown = hidden ? 1 : glm::length(seen_way);
            point.metres_per_px = px / shown / seen.scale * per_metre;
            const double far_px = metres * seen.scale / px * shown;
            point.p_px += point.way_px * std::max(far_px, least_px * scale);
        }
        out.push_back(point);
    };
    add(IncisionHold::place, step_away_from(seen, crossed, {32, 40, 26, 48, 14, 54}), {}, 0, 0, 0);
    add(IncisionHold::start, 0, {}, 0, 0, 0);
    add(IncisionHold::end, SeenCut::steps, {}, 0, 0, 0);
    const std::size_t k = step_of_opening(seen, crossed);
    const double full = full_share(incision, seen, k) * incision.cut.width;
    const double half = full * incision.opening.share / 2;
    add(IncisionHold::open_left, k, -seen.across[k], least_open_px, half, 2 / full);
    add(IncisionHold::open_right, k, seen.across[k], least_open_px, half, 2 / full);
    const std::size_t d = step_away_from(seen, crossed, {19, 45, 12, 52});
    add(IncisionHold::depth, d, -seen.line[d].normal_world, least_deep_px, incision.cut.depth, 1);
    // The knot hangs beside the cut, so that it never lies on an end
    const glm::dvec3 zip = seen.at(incision.opening.to);
    const auto step = std::min(
        static_cast<std::size_t>(incision.opening.to * static_cast<double>(SeenCut::steps)),
        SeenCut::steps);
    if (const auto at = cut_pixel(camera, zip)) {
        const auto right = cut_pixel(camera, zip + seen.across[step] * world_per_px(camera, zip));
        glm::dvec2 off = right ? unit_or(*right - *at, {0, -1}) : glm::dvec2(0, -1);
        if (off.y > 0) off = -off;
        out.push_back({IncisionHold::zip, *at + off * zip_off_px * scale, *at, off});
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
        if (const auto other = snap_near(drag.snaps, drag.camera, moved_px, drag.scale)) {
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
        const SurfacePoint& middle = drag.seen
                                         .line[static_cast<std::size_t>(
                                             drag.held.share * static_cast<double>(SeenCut::steps))]
                                         .at_rest;
        // Beyond an edge of the skin it stays where it was
        if (auto moved =
                moved_over(drag.skin, to.cut.stroke, middle, hit->at_rest, 0.5 * drag.seen.length))
            to.cut.stroke = *std::move(moved);
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

bool types_length(IncisionHold hold)
{
    return hold == IncisionHold::depth;
}

std::optional<EditIncision> typed_in(const IncisionDrag& drag, double number)
{
    EditIncision out{drag.object, drag.number, drag.before};
    NamedIncision& to = out.incision;
    to.cut.stroke.clear();
    switch (drag.held.hold) {
    case IncisionHold::none:
    case IncisionHold::start:
    case IncisionHold::end:
    case IncisionHold::place: return {};
    case IncisionHold::open_left:
    case IncisionHold::open_right: {
        const double share = std::max(number / 100, 0.0);
        to.opening.share = std::min(share, 1.0);
        if (share > 1) to.cut.width = handy_length(drag.before.cut.width * share, false);
        return out;
    }
    case IncisionHold::depth: to.cut.depth = std::max(number / drag.seen.scale, 1e-6); return out;
    case IncisionHold::zip: to.opening.to = std::clamp(number / 100, 0.0, 1.0); return out;
    }
    return {};
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
    case IncisionHold::place: // on the model, as in the inspector
        return "Length " + ui::short_number(rounded(seen.length, 3)) + " m";
    case IncisionHold::open_left:
    case IncisionHold::open_right:
        return fmt::format("Opening {} %, {}", number_text(100 * incision.opening.share),
                           metres(incision.opening.share * incision.cut.width * seen.widest));
    case IncisionHold::depth: {
        std::string words = "Depth " + metres(incision.cut.depth);
        if (seen.depth < 0.98 * incision.cut.depth) words += ", here at most " + metres(seen.depth);
        return words;
    }
    case IncisionHold::zip:
        return fmt::format("Open until {} %", number_text(100 * incision.opening.to));
    }
    return "";
}

} // namespace trivar
