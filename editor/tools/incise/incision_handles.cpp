// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_handles.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double incision_reach_px = 10;  // of the mouse
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
std::size_t step_away_from(const SeenIncision& seen, std::span<const double> crossed,
                           std::initializer_list<std::size_t> steps)
{
    constexpr double apart = 0.09;
    const auto on_part = [&](std::size_t step) { return std::clamp(step, seen.first, seen.last); };
    for (const std::size_t step : steps) {
        const double share = static_cast<double>(step) / static_cast<double>(SeenIncision::steps);
        if (step == on_part(step) && std::ranges::none_of(crossed, [&](double each) {
                return std::abs(each - share) < apart;
            }))
            return step;
    }
    return on_part(*steps.begin());
}

// The step at which the handles of the opening stand: the widest one, or about there.
std::size_t step_of_opening(const SeenIncision& seen, std::span<const double> crossed)
{
    constexpr std::size_t off = 8, least = 10;
    const std::size_t k = seen.widest_at;
    if (k < least || k + least > SeenIncision::steps) return k;
    return step_away_from(seen, crossed, {k, k - off, k + off, k - least, k + least});
}

// The share of the width by which the lips are apart at a step when it is quite open.
double full_share(const NamedIncision& incision, const SeenIncision& seen, std::size_t step)
{
    constexpr double least = 0.15; // nearer to an end a small drag would be a large opening
    const double x = static_cast<double>(step) / static_cast<double>(SeenIncision::steps);
    IncisionOpening quite = incision.opening;
    quite.share = 1;
    return std::max(least, value_at(incision.cut.opening_profile, x) * share_at(quite, x)) *
           seen.widest;
}

double handy_length(double metres, bool snap)
{
    return rounded(metres, snap ? 1 : 3);
}

double handy_share(double share, bool snap)
{
    return snap ? std::round(share * 20) / 20 : std::round(share * 1000) / 1000;
}

// An IncisionPull is a hand that pulls a taken incision to a pixel.
struct IncisionPull {
    const TakenIncision& taken;
    const HandMove& move;
    glm::dvec2 to_px{0};
};
using IncisionChange = std::function<void(NamedIncision& to, const IncisionPull& pull)>;

HandleDrag drag_of(const std::optional<TakenIncision>& taken, const IncisionChange& change,
                   glm::dvec2 base_px)
{
    if (!taken) return {};
    return {[taken = *taken, change, base_px](const HandMove& move) {
        const auto index = static_cast<std::size_t>(taken.number) - 1;
        EditIncision out{taken.object, taken.number, taken.incising().cuts.at(index)};
        change(out.incision, {taken, move, base_px + move.by_px()});
        return out;
    }};
}

// A SeenWay is a way off the skin at a step of an incision, as it is seen.
struct SeenWay {
    glm::dvec2 way_px{0};     // unit
    double metres_per_px = 0; // on the model
    // The distance that a hand has come along it, in a unit of which a metre is so many.
    double by(const HandMove& move, double per_metre = 1) const
    {
        return glm::dot(move.by_px(), way_px) * (metres_per_px * per_metre);
    }
    glm::dvec2 off(double metres, double least_px) const
    {
        return way_px * std::max(metres / metres_per_px, least_px);
    }
};
// Nothing: it points at the eye. With `beside` that is drawn and dragged downward, or to the right
// beside a cut that goes down itself.
std::optional<SeenWay> seen_way(const SeenIncision& seen, std::size_t step,
                                const glm::dvec3& way_world, const Camera& camera, bool beside)
{
    const glm::dvec3& base = seen.line[step].p_world;
    const double px = world_per_px(camera, base);
    const auto pixel = [&](const glm::dvec3& p) { return project(camera, p).p_px; };
    const glm::dvec2 way = pixel(base + way_world * px) - pixel(base); // per pixel of length
    if (!(glm::length(way) < opening_end_on))
        return SeenWay{glm::normalize(way), px / glm::length(way) / seen.scale};
    if (!beside) return {};
    const glm::dvec2 along = pixel(seen.line[std::min(step + 2, SeenIncision::steps)].p_world) -
                             pixel(seen.line[step > 2 ? step - 2 : 0].p_world);
    return SeenWay{std::abs(along.y) > std::abs(along.x) ? glm::dvec2(1, 0) : glm::dvec2(0, 1),
                   px / seen.scale};
}

// Makes handles that are tied to points of the scene.
struct IncisionHandles {
    const Camera& camera;
    const TakeIncision& take;
    std::vector<Handle> out = {};
    // `off_px`: so far from its point it is drawn. Nothing behind the eye is added.
    void add(Handle handle, const glm::dvec3& p_world, glm::dvec2 off_px,
             const IncisionChange& change)
    {
        const auto at = cut_pixel(camera, p_world);
        if (!at) return;
        handle.p_world = p_world;
        handle.base_px = *at;
        handle.p_px = *at + off_px;
        handle.reach_px = incision_reach_px;
        handle.take = [take = take, change, at] { return drag_of(take(), change, *at); };
        out.push_back(std::move(handle));
    }
};

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

void move_end(const TakenIncision& taken, bool start, const SurfacePoint& to, Incision& cut)
{
    std::vector<SurfacePoint> points = cut.stroke.size() < fewest_points
                                           ? at_equal_steps(cut.stroke, 2 * fewest_points)
                                           : cut.stroke;
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
        on_the_skin(taken.skin, wanted, points, glm::length(way) + 0.02 * taken.skin.diagonal());
    moved.front() = points.front();
    moved.back() = to;
    if (start) std::ranges::reverse(moved);
    for (SurfacePoint& each : moved) each = handy(each);
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

// Moves all of it over the skin, by the place at a step; beyond an edge of that it stays as it was.
void move_all(NamedIncision& to, const IncisionPull& pull, std::size_t step)
{
    const TakenIncision& taken = pull.taken;
    const auto hit = taken.skin.shut_hit(ray_through(pull.move.camera, pull.to_px));
    if (!hit) return;
    if (auto moved = moved_over(taken.skin, to.cut.stroke, taken.seen.line[step].at_rest,
                                hit->at_rest, 0.5 * taken.seen.length))
        to.cut.stroke = *std::move(moved);
}

void move_end(NamedIncision& to, const IncisionPull& pull, bool start)
{
    const HandMove& move = pull.move;
    const auto other = snap_near(pull.taken.snaps, move.camera, pull.to_px, move.scale);
    if (other) return move_end(pull.taken, start, other->at_rest, to.cut);
    const auto hit = pull.taken.skin.shut_hit(ray_through(move.camera, pull.to_px));
    if (hit) move_end(pull.taken, start, hit->at_rest, to.cut);
}

void open_by(NamedIncision& to, const HandMove& move, double by)
{
    to.cut.stroke.clear();
    const double share = std::max(0.0, move.typed ? *move.typed / 100 : to.opening.share + by);
    to.opening.share = std::min(1.0, move.typed ? share : handy_share(share, move.snap));
    // More than quite open: it becomes wider
    if (share > 1) to.cut.width = handy_length(to.cut.width * share, move.snap && !move.typed);
}

void deepen(NamedIncision& to, const IncisionPull& pull, double by)
{
    to.cut.stroke.clear();
    const double before = to.cut.depth, least = 0.02 * before;
    to.cut.depth = pull.move.typed ? std::max(*pull.move.typed / pull.taken.seen.scale, 1e-6)
                                   : handy_length(std::max(least, before + by), pull.move.snap);
}

void zip_to(NamedIncision& to, const IncisionPull& pull)
{
    to.cut.stroke.clear();
    if (pull.move.typed)
        to.opening.to = std::clamp(*pull.move.typed / 100, 0.0, 1.0);
    else if (const auto near = near_cut(pull.taken.seen, pull.move.camera, pull.to_px))
        to.opening.to = handy_share(near->share, pull.move.snap);
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

std::vector<Handle> incision_handles(const NamedIncision& shown, const NamedIncision& now,
                                     const SeenIncision& seen, const Camera& camera, double scale,
                                     std::span<const double> crossed, const TakeIncision& take)
{
    IncisionHandles handles{camera, take};
    const auto metres = [&](double on_model) {
        return ui::short_number(rounded(on_model * seen.scale, 3)) + " m";
    };
    // On the model, as in the inspector
    const std::string length = "Length " + ui::short_number(rounded(seen.length, 3)) + " m";
    const std::size_t middle = step_away_from(seen, crossed, {32, 40, 26, 48, 14, 54});
    handles.add(
        {.key = {"place"},
         .look = Handle::Look::hollow, // it changes no number
         .color = &ui::Palette::incision,
         .words = length,
         .verb = "Drag to move it over the skin"},
        seen.line[middle].p_world, {},
        [middle](NamedIncision& to, const IncisionPull& pull) { move_all(to, pull, middle); });
    for (const bool start : {true, false})
        handles.add(
            {.key = {start ? "start" : "end"},
             .color = &ui::Palette::incision,
             .words = length,
             .verb = "Drag to move this end"},
            seen.line[start ? 0 : SeenIncision::steps].p_world, {},
            [start](NamedIncision& to, const IncisionPull& pull) { move_end(to, pull, start); });
    const std::size_t k = step_of_opening(seen, crossed);
    const double full = full_share(shown, seen, k) * shown.cut.width;
    for (const double side : {-1.0, 1.0})
        if (const auto way = seen_way(seen, k, side * seen.across[k], camera, false))
            handles.add(
                {.key = {side < 0 ? "left" : "right"},
                 .way_px = way->way_px,
                 .color = &ui::Palette::free_node,
                 .lit = &ui::Palette::incision,
                 .words = fmt::format("Opening {} %, {}", number_text(100 * now.opening.share),
                                      metres(now.opening.share * now.cut.width * seen.widest)),
                 .number = Handle::Number::percent,
                 .verb = "Drag to open or close it"},
                seen.line[k].p_world,
                way->off(full * shown.opening.share / 2, least_open_px * scale),
                [way = *way, full](NamedIncision& to, const IncisionPull& pull) {
                    open_by(to, pull.move, way.by(pull.move, 2 / full));
                });
    const std::size_t d = step_away_from(seen, crossed, {19, 45, 12, 52});
    std::string depth = "Depth " + metres(now.cut.depth);
    if (seen.depth < 0.98 * now.cut.depth) depth += ", here at most " + metres(seen.depth);
    const SeenWay down = *seen_way(seen, d, -seen.line[d].normal_world, camera, true);
    handles.add({.key = {"depth"},
                 .way_px = down.way_px,
                 .look = Handle::Look::arrow,
                 .thread = Handle::Thread::always,
                 .color = &ui::Palette::lattice,
                 .words = depth,
                 .number = Handle::Number::length,
                 .verb = "Drag to cut deeper"},
                seen.line[d].p_world, down.off(shown.cut.depth, least_deep_px * scale),
                [down](NamedIncision& to, const IncisionPull& pull) {
                    deepen(to, pull, down.by(pull.move));
                });
    // The knot hangs beside the cut, so that it never lies on an end
    const glm::dvec3 zip = seen.at(shown.opening.to);
    const auto step = std::min(
        static_cast<std::size_t>(shown.opening.to * static_cast<double>(SeenIncision::steps)),
        SeenIncision::steps);
    const auto at = cut_pixel(camera, zip),
               right = cut_pixel(camera, zip + seen.across[step] * world_per_px(camera, zip));
    glm::dvec2 off = at && right ? unit_or(*right - *at, {0, -1}) : glm::dvec2(0, -1);
    if (off.y > 0) off = -off;
    handles.add({.key = {"zip"},
                 .look = Handle::Look::diamond,
                 .thread = Handle::Thread::always,
                 .color = &ui::Palette::path,
                 .words = fmt::format("Open until {} %", number_text(100 * now.opening.to)),
                 .number = Handle::Number::percent,
                 .verb = "Drag along the cut to zip it"},
                zip, off * zip_off_px * scale, zip_to);
    return std::move(handles.out);
}

} // namespace trivar
