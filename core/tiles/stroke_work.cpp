// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/stroke_work.h"

#include "core/tiles/filled_triangles.h"
#include "core/tiles/on_surface.h"
#include "core/tiles/straightest.h"
#include "core/tiles/tile_brushes.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

// The purpose of a random number; a new purpose does not change the numbers of the others.
enum Purpose : std::uint32_t { across, around, size, turn, heading, triangle, side };

std::vector<StrandPoint> strand_points(const std::vector<StrokeStep>& path)
{
    std::vector<StrandPoint> out;
    for (const StrokeStep& each : path)
        out.push_back({{each.p, each.n}, each.time_s, each.pressure});
    return out;
}

// Largest number of tiles that are tried for all strokes together, so that no file blocks the
// editor.
constexpr int most_tries = 20 * static_cast<int>(most_tiles);

// Where a stroke does not say how long it took, it took a second.
double duration_of(const TileStroke& stroke)
{
    const double last = stroke.samples.back().time_s;
    return stroke.brush != TileBrush::fill && last > 0 ? last : 1;
}

double time_of(const TileStroke& stroke, std::size_t sample)
{
    if (stroke.samples.back().time_s > 0) return stroke.samples[sample].time_s;
    return static_cast<double>(sample) /
           std::max<double>(1, static_cast<double>(stroke.samples.size()) - 1);
}

} // namespace

StrokeWork::StrokeWork(const TileBase& base, double cube)
    : base_(base),
      estimate_([&base] { return TileCurvature(base); }),
      laid_{base, {}, {}, NearTiles(cube)}
{
}

void StrokeWork::attend(const Progress& progress, const Lazy<TileCurvature>* curvature)
{
    progress_ = &progress;
    curvature_ = curvature ? curvature : &estimate_;
}

void StrokeWork::go_back_to(const State& state)
{
    laid_.tiles = state.tiles;
    laid_.gone = state.gone;
    while (laid_.near.size() > state.near) laid_.near.remove_last();
    tries_ = state.tries;
    out_ = state.out;
    dab_.reset();
}

void StrokeWork::go_on(const State& before, const TileStroke& stroke, int number)
{
    const std::vector<StrokeStep> path = std::move(path_);
    out_ = before.out;
    path_ = path_of(stroke);
    const auto alike =
        static_cast<std::size_t>(std::ranges::mismatch(path, path_).in1 - path.begin());
    if (dab_->step > alike || dab_->step >= path_.size()) {
        go_back_to(before);
        return work_off(stroke, number);
    }
    const Dab dab = *dab_;
    const int lost = out_.lost; // with samples that are new
    go_back_to(dab.before);
    out_.lost = lost;
    made_ = dab.made;
    scatter(stroke, number, dab.step, dab.since);
    out_.duration_s += duration_of(stroke);
}

// Returns the tiles that are left.
Runs<Tile> StrokeWork::left()
{
    Runs<Tile> out;
    const std::vector<Runs<Tile>::Run>& tiles = laid_.tiles.runs();
    const std::vector<Runs<char>::Run>& gone = laid_.gone.runs();
    left_.resize(tiles.size());
    for (std::size_t r = 0; r < tiles.size(); ++r) {
        if (std::ranges::count(*gone[r], char(0)) == std::ssize(*gone[r])) {
            out.add(tiles[r]);
            continue;
        }
        Left& known = left_[r];
        if (known.tiles != tiles[r] || known.gone != gone[r]) {
            std::vector<Tile> those;
            for (std::size_t i = 0; i < tiles[r]->size(); ++i)
                if (!(*gone[r])[i]) those.push_back((*tiles[r])[i]);
            known = {tiles[r], gone[r], make_ref(std::move(those))};
        }
        out.add(known.left);
    }
    return out;
}

TileLayout StrokeWork::result()
{
    TileLayout out = out_;
    out.tiles = left();
    return out;
}

std::vector<StrokeStep> StrokeWork::path_of(const TileStroke& stroke)
{
    const std::vector<std::optional<SurfacePlace>>& places = located(stroke);
    std::vector<StrokeStep> path;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) {
            ++out_.lost;
            continue;
        }
        path.push_back({*places[i], base_.position(*places[i]), base_.normal(*places[i]),
                        glm::dvec3(0), out_.duration_s + time_of(stroke, i),
                        stroke.samples[i].pressure});
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::dvec3 way = path[std::min(i + 1, path.size() - 1)].p - path[i > 0 ? i - 1 : 0].p;
        path[i].ahead = direction_on(glm::length(way) > 0 ? way : glm::dvec3(1, 0, 0), path[i].n);
    }
    return path;
}

// Where samples are on the surface; those that the last stroke had are known.
const std::vector<std::optional<SurfacePlace>>& StrokeWork::located(const TileStroke& stroke)
{
    std::vector<SurfacePoint> points;
    for (const TileSample& each : stroke.samples) points.push_back(each.at);
    const auto known =
        located_.reach != reach_of(stroke)
            ? 0
            : std::ranges::mismatch(located_.points, points).in1 - located_.points.begin();
    located_.places.resize(static_cast<std::size_t>(known));
    const auto others =
        base_.locate(std::span(points).subspan(static_cast<std::size_t>(known)), reach_of(stroke));
    located_.places.insert(located_.places.end(), others.begin(), others.end());
    located_.points = std::move(points);
    located_.reach = reach_of(stroke);
    return located_.places;
}

// Returns the distance from their samples within which strokes find the surface.
double StrokeWork::reach_of(const TileStroke& stroke) const
{
    return std::max(stroke.size, 1e-3 * base_.diagonal());
}

// The mirror image of a path, where the base has it; empty: the stroke has no mirror.
std::vector<StrokeStep> StrokeWork::image_of(const TileStroke& stroke,
                                             const std::vector<StrokeStep>& path) const
{
    std::vector<StrokeStep> out;
    if (const std::optional<MirrorPlane> plane = plane_of(stroke.mirror))
        for (StrokeStep step : path)
            if (const auto at = mirrored(*plane, base_, step.at, reach_of(stroke))) {
                step.at = *at;
                step.p = base_.position(*at);
                step.n = base_.normal(*at);
                step.ahead = direction_on(plane->across(step.ahead), step.n);
                out.push_back(step);
            }
    return out;
}

void StrokeWork::work_off(const TileStroke& stroke, int number)
{
    dab_.reset();
    if (stroke.hidden || out_.too_many) return;
    path_ = path_of(stroke);
    const std::vector<StrokeStep>& path = path_;
    if (path.empty()) return;
    switch (stroke.brush) {
    case TileBrush::scatter:
        made_ = 0;
        scatter(stroke, number, 0, 1e300);
        break;
    case TileBrush::line: line(stroke, number, path); break;
    case TileBrush::fill: fill(stroke, number, path); break;
    case TileBrush::grab: {
        std::vector<StrokeStep> image = image_of(stroke, path);
        if (image.size() < path.size()) image.clear(); // it would not say what goes where
        grab_tiles(laid_, path, image);
        return;
    }
    case TileBrush::adjust: adjust_tiles(laid_, stroke, path, image_of(stroke, path)); return;
    case TileBrush::strand:
        strand(stroke, number, path);
        strand(stroke, number, image_of(stroke, path));
        break;
    default: {
        std::vector<StrokeStep> both = path;
        const std::vector<StrokeStep> image = image_of(stroke, path);
        both.insert(both.end(), image.begin(), image.end());
        change_strands(out_.strands, base_, stroke, strand_points(both));
        change_tiles(laid_, stroke, both);
        return;
    }
    }
    out_.duration_s += duration_of(stroke);
}

// Returns the random seed of the next tile. It is drawn whether or not the tile has room, so
// that a removed tile does not change later ones.
std::uint32_t StrokeWork::next_seed(const TileStroke& stroke)
{
    constexpr int reports = 1024; // tries per report
    if (++tries_ > most_tries) out_.too_many = true;
    if (tries_ % reports == 0)
        report(*progress_, static_cast<double>(tries_) / most_tries, "tiles");
    return random_bits(static_cast<std::uint32_t>(stroke.seed), made_++);
}

// Lays a tile if there is room, and its image if the stroke has a mirror. A tile that would overlap
// its own image stands on the plane.
void StrokeWork::lay(const TileStroke& stroke, int number, Wanted wanted, bool avoiding)
{
    const double share = 1 - stroke.size_variation * random_share(wanted.seed, Purpose::size);
    const double side = stroke.size * share * wanted.pressure;
    if (!(side > 0)) return;
    const double room = stroke.spacing * stroke.size;
    const std::optional<MirrorPlane> plane = plane_of(stroke.mirror);
    const std::optional<SurfacePlace> on_plane =
        plane ? on_the_plane(*plane, wanted.at, room / 2) : std::nullopt;
    if (on_plane) wanted.at = *on_plane;
    if (avoiding && !has_room(wanted.at, room)) return;
    Tile tile{wanted.at,    heading_of(stroke, wanted), side, stroke.height, wanted.seed, number,
              wanted.time_s};
    if (wanted.along >= 0) {
        tile.track = track_;
        tile.along = wanted.along;
    }
    if (on_plane) { // it is its own image: along the plane or across it
        const glm::dvec3 flat = plane->onto(tile.x);
        tile.x =
            direction_on(glm::length(flat) > 0.7 ? flat : tile.x - flat, base_.normal(tile.at));
    }
    if (!add(tile) || !plane || on_plane) return;
    const std::optional<SurfacePlace> image = mirrored(*plane, base_, tile.at, reach_of(stroke));
    if (!image || (avoiding && !has_room(*image, room))) return;
    tile.at = *image;
    tile.x = direction_on(plane->across(tile.x), base_.normal(*image));
    if (tile.track >= 0) tile.track = image_track_;
    tile.mirrored = stroke.mirrors_tiles;
    add(tile);
}

bool StrokeWork::has_room(const SurfacePlace& at, double room) const
{
    const glm::dvec3 n = base_.normal(at);
    return !laid_.near.any(base_.position(at), room, [&](int other, double distance) {
        const auto o = static_cast<std::size_t>(other);
        return !laid_.gone[o] && distance < room && // on this side of the surface
               same_side(base_.normal(laid_.tiles[o].at), n);
    });
}

bool StrokeWork::add(const Tile& tile)
{
    if (laid_.tiles.size() >= most_tiles) {
        out_.too_many = true;
        return false;
    }
    laid_.add(tile);
    return true;
}

// Where the surface meets the plane beside a place that is nearer to it than `near`.
std::optional<SurfacePlace> StrokeWork::on_the_plane(const MirrorPlane& plane,
                                                     const SurfacePlace& at, double near) const
{
    const glm::dvec3 p = base_.position(at), n = plane.onto(base_.normal(at));
    const double length = glm::length(n);
    if (!(std::abs(p[plane.axis]) < near) || !(length > 0.5)) return std::nullopt;
    const SurfacePoint beside{plane.onto(p), n / length};
    return base_.locate({&beside, 1}, 2 * near).front();
}

glm::dvec3 StrokeWork::heading_of(const TileStroke& stroke, const Wanted& wanted)
{
    const glm::dvec3 n = base_.normal(wanted.at);
    glm::dvec3 x = direction_on(wanted.ahead, n);
    switch (stroke.heading) {
    case TileHeading::along_stroke: break;
    case TileHeading::upward: x = direction_on({0, 0, 1}, n); break;
    case TileHeading::random:
        x = turned_about(x, n, glm::two_pi<double>() * random_share(wanted.seed, Purpose::heading));
        break;
    case TileHeading::least_curvature:
    case TileHeading::most_curvature: {
        glm::dvec3 least = (**curvature_).least(base_, wanted.at);
        if (least == glm::dvec3(0)) break;
        if (stroke.heading == TileHeading::most_curvature) least = glm::cross(n, least);
        x = direction_on(glm::dot(least, x) < 0 ? -least : least, n); // on with the stroke
        break;
    }
    case TileHeading::to_point:
        x = direction_on(stroke.point - base_.position(wanted.at), n);
        break;
    }
    const double most = glm::radians(stroke.turn_variation_deg);
    return turned_about(x, n, most * (2 * random_share(wanted.seed, Purpose::turn) - 1));
}

// Scatters tiles from a step of the path on; the last dab is `since` behind it.
void StrokeWork::scatter(const TileStroke& stroke, int number, std::size_t step, double since)
{
    const std::vector<StrokeStep>& path = path_;
    // The number of tries is twice the number of discs of the spacing's radius that fill the
    // brush.
    const double room = std::max(stroke.spacing * stroke.size, 1e-6 * base_.diagonal());
    const double radius = std::min(stroke.radius, base_.diagonal()), share = radius / room;
    const int tries = static_cast<int>(std::clamp(std::ceil(8 * share * share), 1.0, 4096.0));
    struct Place {
        std::size_t step;
        double since; // length since the last dab, up to the step before
    };
    std::vector<Place> dabs;
    for (std::size_t i = step; i < path.size(); ++i) {
        const double before = since;
        if (i > 0) since += glm::distance(path[i].p, path[i - 1].p);
        if (since < radius / 2) continue;
        dabs.push_back({i, before});
        since = 0;
    }
    for (const auto& [i, before] : dabs) {
        if (out_.too_many) break;
        if (i == dabs.back().step) dab_ = Dab{state(), made_, before, i};
        const glm::dvec3 ahead = path[i].ahead;
        for (int k = 0; k < tries && !out_.too_many; ++k) {
            const std::uint32_t seed = next_seed(stroke);
            const double away = radius * std::sqrt(random_share(seed, Purpose::across));
            const double angle = glm::two_pi<double>() * random_share(seed, Purpose::around);
            const SurfaceRay ray =
                straightest(base_, path[i].at, away * turned_about(ahead, path[i].n, angle));
            if (ray.left > 0) continue;
            const SurfacePlace at = inside(ray.at);
            const glm::dvec3 n = base_.normal(at);
            // The direction of the stroke keeps its angle to the path.
            const glm::dvec3 x = turned_about(direction_on(ray.direction, n), n, -angle);
            lay(stroke, number, {seed, at, x, path[i].time_s, path[i].pressure}, true);
        }
    }
    if (out_.too_many) dab_.reset();
}

void StrokeWork::line(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path)
{
    made_ = 0;
    const double step = std::max(stroke.spacing * stroke.size, 1e-6 * base_.diagonal());
    begin_tracks(stroke, path, step);
    lay(stroke, number,
        {next_seed(stroke), path.front().at, path.front().ahead, path.front().time_s,
         path.front().pressure, 0},
        false);
    double next = step, before = 0; // length to the next tile, and of the way up to here
    for (std::size_t i = 1; i < path.size() && !out_.too_many; ++i) {
        const StrokeStep &a = path[i - 1], &b = path[i];
        const double length = glm::distance(a.p, b.p);
        double gone = next;
        for (; gone <= length && !out_.too_many; gone += step) {
            const glm::dvec3 way = gone * direction_on(b.p - a.p, a.n);
            const SurfaceRay ray = straightest(base_, a.at, way);
            const double share = gone / length;
            lay(stroke, number,
                {next_seed(stroke), inside(ray.at), b.p - a.p, glm::mix(a.time_s, b.time_s, share),
                 glm::mix(a.pressure, b.pressure, share), before + gone},
                false);
        }
        next = gone - length;
        before += length;
    }
}

// Notes the way of a line, and that of its mirror image where it is as long.
void StrokeWork::begin_tracks(const TileStroke& stroke, const std::vector<StrokeStep>& path,
                              double step)
{
    track_ = static_cast<int>(out_.tracks.size());
    out_.tracks.push_back(track_of(path, stroke.size, step));
    const std::vector<StrokeStep> image = image_of(stroke, path);
    image_track_ = image.size() == path.size() ? track_ + 1 : -1;
    if (image_track_ > 0) out_.tracks.push_back(track_of(image, stroke.size, step));
}

void StrokeWork::strand(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path)
{
    if (path.empty()) return;
    add_strand(out_.strands, base_, stroke, number, strand_points(path));
    out_.too_many |= out_.strands.too_many;
}

void StrokeWork::fill(const TileStroke& stroke, int number, const std::vector<StrokeStep>& path)
{
    made_ = 0;
    const std::vector<std::uint32_t> all = filled_triangles(base_, stroke.area, path);
    std::vector<double> sums;
    double area = 0;
    for (const std::uint32_t t : all) sums.push_back(area += base_.area(t));
    const double room = std::max(stroke.spacing * stroke.size, 1e-6 * base_.diagonal());
    // Random tries fill a surface slowly in the end: ten tries per place of a tile.
    const double tries =
        std::min<double>(std::ceil(10 * area / (0.7 * room * room)), most_tries + 1);
    const glm::dvec3 ahead = path.front().ahead;
    for (int k = 0; k < static_cast<int>(tries) && !out_.too_many; ++k) {
        const std::uint32_t seed = next_seed(stroke);
        const double at = area * random_share(seed, Purpose::triangle);
        const auto found =
            std::min(static_cast<std::size_t>(std::ranges::upper_bound(sums, at) - sums.begin()),
                     all.size() - 1);
        const double u = std::sqrt(random_share(seed, Purpose::across)),
                     v = random_share(seed, Purpose::side);
        const SurfacePlace place{all[found], {1 - u, u * (1 - v), u * v}};
        // It spreads from where it began.
        const double way = glm::distance(base_.position(place), path.front().p);
        lay(stroke, number,
            {seed, place, ahead, out_.duration_s + std::min(1.0, way / base_.diagonal()),
             path.front().pressure},
            true);
    }
}

} // namespace trivar
