// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/placement_holds.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/words/changes.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/placement/redraw.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double px_a_place = 130; // of the stroke, as it was drawn
constexpr int least_places = 3, most_places = 9;
constexpr double least_ratio = 0.05, most_ratio = 20; // of sizes, in one drag
constexpr double shortest_fill = 0.02;
constexpr double reach_px = 9;      // of a handle
constexpr double end_on_px = 14;    // a size that looks shorter is on a stalk ...
constexpr double stalk_px = 44;     // ... of this length
constexpr double narrowest_px = 11; // a rim, from the middle
constexpr double beyond_px = 16;    // start and end, from the ends
constexpr double further_in = 0.02; // along the stroke
constexpr double across_at_u = 0.6; // where the points of the height across stand

glm::dvec3 in_volume(const Placement& placement, const glm::dvec3& uvw)
{
    return evaluate(placement.volume, uvw).value;
}

std::vector<double> profile_shares(const std::vector<glm::dvec2>& profile)
{
    std::vector<double> out;
    for (const glm::dvec2& p : profile) out.push_back(p.x);
    return out.empty() ? std::vector<double>{0.5} : out;
}

// Four digits, as drags of numbers give; in round steps a tenth of the size.
double handy(double value, bool snap)
{
    return rounded(value, snap ? 2 : 4);
}

// Whether the way from its base to the hold can hardly be seen.
bool end_on(const HoldPoint& point, const Camera& camera, double scale)
{
    const HoldKind kind = point.hold.kind;
    if (kind != HoldKind::height && kind != HoldKind::map && kind != HoldKind::contact &&
        kind != HoldKind::sunk)
        return false;
    return glm::distance(project(camera, point.p_world).p_px,
                         project(camera, point.base_world).p_px) < end_on_px * scale;
}

// Returns how many times longer the way from its base to the hold has become.
double growth(const HoldDrag& drag, glm::dvec2 by_px)
{
    const PicturePoint base = project(drag.camera, drag.held.base_world);
    const glm::dvec2 way = project(drag.camera, drag.held.p_world).p_px - base.p_px;
    if (end_on(drag.held, drag.camera, drag.scale)) { // a pixel upward is a pixel's length
        const double size = glm::distance(drag.held.p_world, drag.held.base_world);
        const double up = -by_px.y * pixel_size_world(drag.camera, base.depth_world);
        const HoldKind kind = drag.held.hold.kind;
        const double sign = kind == HoldKind::height || kind == HoldKind::map ? 1 : -1;
        return std::clamp(1 + sign * up / size, least_ratio, most_ratio);
    }
    const double square = glm::dot(way, way);
    if (!(square > 1)) return 1;
    return std::clamp(glm::dot(way + by_px, way) / square, least_ratio, most_ratio);
}

// A point of a profile so that the curve there is as high as asked for.
void raise(std::vector<glm::dvec2>& profile, std::size_t point, double wanted, bool snap)
{
    const double u = profile[point].x, before = ShareCurve(profile).at(u);
    std::vector<glm::dvec2> higher = profile;
    higher[point].y += 1;
    // The weight of the point's height on the curve.
    const double weight = ShareCurve(higher).at(u) - before;
    profile[point].y = handy(profile[point].y + (wanted - before) / std::max(0.1, weight), snap);
}

// A size without a profile grows as a whole, else the profile does at its point.
void grow(double& size, std::vector<glm::dvec2>& profile, double present, std::size_t point,
          double times, bool snap)
{
    if (profile.empty()) {
        size = handy(present * times, snap);
        return;
    }
    raise(profile, point, Profile(profile).at(profile[point].x) * times, snap);
    profile[point].y = std::clamp(profile[point].y, least_profile, most_profile);
}

// The value of a height map so that the surface there is so many times as high.
void raise(HeightGrid& grid, int index, double times, bool snap)
{
    const HeightMap map(grid);
    const auto columns = static_cast<int>(grid.front().size());
    const int i = index / columns, j = index % columns;
    const auto I = static_cast<std::size_t>(i), J = static_cast<std::size_t>(j);
    const double before = map.at(map.along()[I], map.across()[J]);
    const double by = before * (times - 1) / std::max(0.1, map.weight(i, j));
    grid[I][J] = std::clamp(handy(grid[I][J] + by, snap), least_profile, most_profile);
}

Sketch pulled(const HoldDrag& drag, glm::dvec2 to_px)
{
    const Camera& drawn = drag.step.sketch.camera;
    const glm::dmat4 from_world = glm::inverse(drag.to_world);
    const Camera camera = carried(drag.camera, from_world);
    const glm::dvec3 held(from_world * glm::dvec4(drag.held.p_world, 1));
    const glm::dvec2 own = project(drawn, held).p_px;
    std::vector<StrokeSample> seen =
        seen_from(drawn, camera, {{drag.from_px, 0, 1}, {to_px, 0, 1}}, *drag.scene);
    glm::dvec2 by(0);
    if (seen.size() == 2)
        by = seen[1].p_px - seen[0].p_px;
    else { // in the plane of the picture, at the depth of the hold
        const double depth = project(camera, held).depth_world;
        const auto at = [&](glm::dvec2 p) {
            const Ray ray = ray_through(camera, p);
            const double along = project(camera, ray.origin + ray.direction).depth_world;
            const double start = project(camera, ray.origin).depth_world;
            return ray.origin + ray.direction * ((depth - start) / (along - start));
        };
        by = project(drawn, held + at(to_px) - at(drag.from_px)).p_px - own;
    }
    const double share = nearest_share(drag.step.sketch, own).share;
    const double reach =
        std::clamp(px_a_place / length_px(drag.step.sketch.samples), 1.0 / most_places, 0.5);
    return bent(drag.step.sketch, share, by, reach);
}

} // namespace

std::vector<HoldPoint> hold_points(const PlacementStep& step, const Placement& placement)
{
    const PlacementParameters& p = step.parameters;
    const double w0 = placement.ground;
    const double far = w0 > 0.5 ? 0 : 1; // the face that is further from the scene
    std::vector<HoldPoint> out;
    const auto add = [&](HoldKind kind, int index, const glm::dvec3& uvw, const glm::dvec3& base) {
        out.push_back(
            {{kind, index}, uvw.x, in_volume(placement, uvw), in_volume(placement, base)});
    };
    int index = 0;
    for (const double u : profile_shares(p.width_profile)) {
        add(HoldKind::width, index++, {u, 0, w0}, {u, 0.5, w0});
        add(HoldKind::width, index++, {u, 1, w0}, {u, 0.5, w0});
    }
    index = 0;
    if (p.height_map.empty() || !p.height_profile.empty()) // else its own points are there
        for (const double u : profile_shares(p.height_profile))
            add(HoldKind::height, index++, {u, 0.5, far}, {u, 0.5, w0});
    for (std::size_t i = 0; i < p.height_across.size(); ++i)
        add(HoldKind::across, static_cast<int>(i), {across_at_u, p.height_across[i].x, far},
            {across_at_u, p.height_across[i].x, w0});
    index = 0;
    const HeightMap map(p.height_map);
    for (const double u : map.along())
        for (const double v : map.across()) add(HoldKind::map, index++, {u, v, far}, {u, v, w0});
    for (std::size_t i = 1; i + 1 < p.rise_profile.size(); ++i)
        add(HoldKind::rise, static_cast<int>(i), {2.0 / 3, 0, p.rise_profile[i].x},
            {2.0 / 3, 0, 0});
    if (!step.round) add(HoldKind::contact, 0, {1.0 / 3, 1, w0}, {1.0 / 3, 1, far});
    if (placement.contact.axes[0].closure() != Closure::twisted)
        add(HoldKind::sunk, 0, {2.0 / 3, 1, 0}, {2.0 / 3, 1, 1});
    const int places =
        std::clamp(1 + static_cast<int>(std::lround(length_px(step.sketch.samples) / px_a_place)),
                   least_places, most_places);
    for (int i = 0; i < places && !step.round; ++i) {
        const double u = static_cast<double>(i) / (places - 1);
        add(HoldKind::stroke, i, {u, 0.5, w0}, {u, 0.5, w0});
    }
    const double end = p.start + p.fill;
    add(HoldKind::start, 0, {p.start, 0.5, w0}, {p.start + further_in, 0.5, w0});
    add(HoldKind::end, 0, {end, 0.5, w0}, {end - further_in, 0.5, w0});
    return out;
}

std::optional<glm::dvec2> seen_at(const HoldPoint& point, const Camera& camera, double scale)
{
    const PicturePoint p = project(camera, point.p_world), base = project(camera, point.base_world);
    if (p.depth_world <= 0) return {};
    const HoldKind kind = point.hold.kind;
    if (end_on(point, camera, scale)) return p.p_px - glm::dvec2(0, stalk_px * scale);
    const glm::dvec2 out = p.p_px - base.p_px;
    const double length = glm::length(out);
    if (kind == HoldKind::rise && length < end_on_px * scale) return {}; // all on one spot
    if (!(length > 0)) return p.p_px;
    if (kind == HoldKind::start || kind == HoldKind::end)
        return p.p_px + out * (beyond_px * scale / length);
    if (kind == HoldKind::width) // a narrow strip's rims keep apart
        return base.p_px + out * std::max(1.0, narrowest_px * scale / length);
    return p.p_px;
}

std::optional<HoldPoint> hold_at(const std::vector<HoldPoint>& points, const Camera& camera,
                                 glm::dvec2 p_px, double scale)
{
    std::optional<HoldPoint> nearest;
    double least = reach_px * scale;
    for (const HoldPoint& point : points) {
        const auto at = seen_at(point, camera, scale);
        if (!at || glm::distance(*at, p_px) > least) continue;
        least = glm::distance(*at, p_px);
        nearest = point;
    }
    return nearest;
}

EditPlacement dragged(const HoldDrag& drag, glm::dvec2 to_px, bool snap)
{
    EditPlacement command{drag.object, drag.step.parameters, {}, {}};
    PlacementParameters& p = command.parameters;
    // Its sizes are those of the space of the stroke.
    const double scale = glm::length(glm::dvec3(drag.to_world[0]));
    const double width = drag.placement->report.width_world / scale,
                 height = drag.placement->report.height_world / scale;
    const glm::dvec2 by = to_px - drag.from_px;
    const auto line = [&] {
        const glm::dvec2 shown = project(drag.camera, drag.held.p_world).p_px;
        const double u = nearest_on_line(*drag.placement, drag.camera, shown + by).u;
        return snap ? std::round(u * 20) / 20 : std::round(u * 1000) / 1000;
    };
    const double end = p.start + p.fill;
    switch (drag.held.hold.kind) {
    case HoldKind::none: break;
    case HoldKind::stroke:
        command.sketch = pulled(drag, to_px);
        command.attach = drag.hosts;
        break;
    case HoldKind::width:
        grow(p.width, p.width_profile, width, static_cast<std::size_t>(drag.held.hold.index / 2),
             growth(drag, by), snap);
        break;
    case HoldKind::height:
        grow(p.height, p.height_profile, height, static_cast<std::size_t>(drag.held.hold.index),
             growth(drag, by), snap);
        break;
    case HoldKind::across:
        grow(p.height, p.height_across, height, static_cast<std::size_t>(drag.held.hold.index),
             growth(drag, by), snap);
        break;
    case HoldKind::map: raise(p.height_map, drag.held.hold.index, growth(drag, by), snap); break;
    case HoldKind::rise: {
        const auto i = static_cast<std::size_t>(drag.held.hold.index);
        std::vector<glm::dvec2>& points = p.rise_profile;
        raise(points, i, ShareCurve(points).at(points[i].x) * growth(drag, by), snap);
        points[i].y =
            std::clamp(points[i].y, points[i - 1].y + least_rise,
                       std::max(points[i - 1].y, points[i + 1].y - 2 * least_rise) + least_rise);
        break;
    }
    case HoldKind::start:
        p.start = std::clamp(line(), 0.0, std::max(0.0, end - shortest_fill));
        p.fill = end - p.start;
        break;
    case HoldKind::end:
        p.fill = std::clamp(line(), std::min(1.0, p.start + shortest_fill), 1.0) - p.start;
        break;
    case HoldKind::sunk: {
        // The floor away from the roof: so much of the height lies deeper.
        const Rise rise(p.rise_profile, drag.placement->volume.displacement.axes[2]);
        const double risen = rise.at(p.contact_level) + growth(drag, by) - 1;
        p.contact_level = handy(rise.w_at(std::clamp(risen, 0.0, 1.0)), snap);
        break;
    }
    case HoldKind::contact: {
        const double deep = glm::distance(drag.held.p_world, drag.held.base_world) / scale;
        const double into = p.contact_level > 0.5 ? -1 : 1; // away from what it is measured from
        const double moved = into * deep * (1 - growth(drag, by));
        p.clearance = std::max(0.0, handy(p.clearance + moved, snap));
        break;
    }
    }
    return command;
}

std::string name_of(HoldKind kind)
{
    switch (kind) {
    case HoldKind::none: return {};
    case HoldKind::stroke: return "Stroke";
    case HoldKind::width: return "Width";
    case HoldKind::height: return "Height";
    case HoldKind::across: return "Height across";
    case HoldKind::map: return "Height map";
    case HoldKind::rise: return "Height distribution";
    case HoldKind::start: return "Start";
    case HoldKind::end: return "End";
    case HoldKind::contact: return "Clearance";
    case HoldKind::sunk: return "Sunk";
    }
    return {};
}

std::string words_of(const Hold& hold, const PlacementParameters& p, const PlacementReport& report)
{
    const auto sized = [&](const char* name, double size, const std::vector<glm::dvec2>& profile,
                           int point) {
        const auto at = static_cast<std::size_t>(point);
        const double factor = at < profile.size() ? Profile(profile).at(profile[at].x) : 1;
        return fmt::format("{} {}", name, in_metres(size * factor));
    };
    switch (hold.kind) {
    case HoldKind::none: return {};
    case HoldKind::stroke: return "length " + in_metres(report.length_world);
    case HoldKind::width:
        return sized("width", report.width_world, p.width_profile, hold.index / 2);
    case HoldKind::height:
        return sized("height", report.height_world, p.height_profile, hold.index);
    case HoldKind::across: return sized("height", report.height_world, p.height_across, hold.index);
    case HoldKind::map: {
        const HeightMap map(p.height_map);
        const auto columns = map.across().size(), at = static_cast<std::size_t>(hold.index);
        if (at >= map.along().size() * columns) return {}; // another hand removed it
        const double u = map.along()[at / columns], v = map.across()[at % columns];
        return "height " + in_metres(report.height_world * Profile(p.height_profile).at(u) *
                                     Profile(p.height_across).at(v) * map.at(u, v));
    }
    case HoldKind::rise: {
        if (static_cast<std::size_t>(hold.index) >= p.rise_profile.size()) return {};
        const glm::dvec2 at = p.rise_profile[static_cast<std::size_t>(hold.index)];
        return fmt::format("{} of the model in {} of the height", percent_text(at.x),
                           percent_text(ShareCurve(p.rise_profile).at(at.x)));
    }
    case HoldKind::start: return fmt::format("start {}", percent_text(p.start));
    case HoldKind::end: return fmt::format("end {}", percent_text(p.start + p.fill));
    case HoldKind::contact: return "clearance " + in_metres(p.clearance);
    case HoldKind::sunk: return fmt::format("sunk {}", percent_text(p.contact_level));
    }
    return {};
}

NearestLine nearest_on_line(const Placement& placement, const Camera& camera, glm::dvec2 p_px)
{
    NearestLine nearest;
    if (placement.strip.empty() || placement.strip.front().size() < 2) return nearest;
    const std::vector<glm::dvec3>& line = placement.strip.front();
    const double steps = static_cast<double>(line.size() - 1);
    PicturePoint before = project(camera, line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const PicturePoint here = project(camera, line[i]);
        if (before.depth_world > 0 && here.depth_world > 0) {
            const glm::dvec2 way = here.p_px - before.p_px;
            const double square = glm::dot(way, way);
            const double f =
                square > 0 ? std::clamp(glm::dot(p_px - before.p_px, way) / square, 0.0, 1.0) : 0;
            const double distance = glm::distance(before.p_px + f * way, p_px);
            if (distance < nearest.distance_px)
                nearest = {(static_cast<double>(i - 1) + f) / steps, distance};
        }
        before = here;
    }
    return nearest;
}

} // namespace trivar
