// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sharp.h"

#include "core/placement/contact.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace trivar {
namespace {

const double aligned_slope = std::tan(glm::radians(10.0));
constexpr double lines_share = 0.6;      // share of the lines that an aligned crease must cross
constexpr std::size_t most_creases = 16; // aligned ones, on each axis
// Share of cells with creases, above which the scene is rubble
constexpr double rough_share = 0.4;
constexpr double most_more = 6;     // times the nodes there were
constexpr double apart_share = 0.3; // share of a span that simple knots keep from a crease

// Says whether creases are nearly everywhere, as in rubble.
bool is_rough(const std::vector<CreasePoint>& all, const StripChart& chart)
{
    const std::vector<double>&us = chart.places(0), &vs = chart.places(1);
    std::set<std::pair<int, int>> cells;
    for (const CreasePoint& c : all)
        cells.emplace(bracket(us, c.uv.x).first, bracket(vs, c.uv.y).first);
    return static_cast<double>(cells.size()) >
           rough_share * static_cast<double>((us.size() - 1) * (vs.size() - 1));
}

// A Crease runs along one axis; its track says where it crosses the lines of the other axis.
struct Crease {
    int across = 0;                // the axis of the lines that it crosses, along which it moves
    std::vector<glm::dvec2> track; // (place of the line, place on it), ascending
    std::vector<std::size_t> used;
    double mean = 0;

    double at(double line) const
    {
        const auto above = std::upper_bound(track.begin(), track.end(), line,
                                            [](double x, const glm::dvec2& p) { return x < p.x; });
        if (above == track.begin()) return track.front().y;
        if (above == track.end()) return track.back().y;
        const glm::dvec2 a = *(above - 1), b = *above;
        return glm::mix(a.y, b.y, (line - a.x) / (b.x - a.x));
    }
};

// Follows crossings of neighbouring lines that may be the same crease, from line to line.
std::vector<Crease> aligned(const std::vector<CreasePoint>& all, const StripChart& chart, int axis)
{
    const std::vector<double>& lines = chart.places(1 - axis);
    std::vector<std::vector<std::size_t>> on(lines.size());
    for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].axis == axis && all[k].line >= 0)
            on[static_cast<std::size_t>(all[k].line)].push_back(k);
    std::vector<char> taken(all.size(), 0);
    const double slope = aligned_slope * chart.length(1 - axis) / chart.length(axis);
    const auto place = [&](std::size_t k) { return all[k].uv[axis]; };
    std::vector<Crease> out;
    for (std::size_t first = 0; first < lines.size(); ++first)
        for (const std::size_t start : on[first]) {
            if (taken[start]) continue;
            Crease crease{axis, {{lines[first], place(start)}}, {start}, 0};
            for (std::size_t line = first + 1; line < lines.size(); ++line) {
                const glm::dvec2 last = crease.track.back();
                std::optional<std::size_t> nearest;
                double least = slope * (lines[line] - last.x) + 1e-9;
                for (const std::size_t k : on[line])
                    if (const double off = std::abs(place(k) - last.y); !taken[k] && off <= least) {
                        least = off;
                        nearest = k;
                    }
                if (!nearest) continue;
                crease.track.emplace_back(lines[line], place(*nearest));
                crease.used.push_back(*nearest);
            }
            if (static_cast<double>(crease.track.size()) <
                std::max(2.0, lines_share * static_cast<double>(lines.size())))
                continue;
            for (const std::size_t k : crease.used) taken[k] = 1;
            for (const glm::dvec2& p : crease.track)
                crease.mean += p.y / static_cast<double>(crease.track.size());
            out.push_back(std::move(crease));
        }
    std::ranges::sort(out, {}, &Crease::mean);
    return out;
}

// Keeps creases that are far enough from the ends and from each other for a span between them.
std::vector<Crease> with_room(std::vector<Crease> creases, const Knots& knots)
{
    const double span = (knots.end() - knots.begin()) / (knots.count() - knots.order() + 1);
    std::vector<Crease> out;
    double last = knots.begin();
    for (Crease& c : creases) {
        if (c.mean - last < apart_share * span || knots.end() - c.mean < apart_share * span ||
            out.size() == most_creases)
            continue;
        last = c.mean;
        out.push_back(std::move(c));
    }
    return out;
}

// Adds order - 1 knots at each crease, and cuts the marked spans.
Knots with_creases(const Knots& knots, const std::vector<Crease>& creases,
                   const std::vector<double>& more)
{
    const double span = (knots.end() - knots.begin()) / (knots.count() - knots.order() + 1);
    std::vector<double> values;
    const auto near_crease = [&](double t) {
        return std::ranges::any_of(
            creases, [&](const Crease& c) { return std::abs(c.mean - t) < apart_share * span; });
    };
    for (const double t : knots.values())
        if (t == knots.begin() || t == knots.end() || !near_crease(t)) values.push_back(t);
    for (const double t : more)
        if (!near_crease(t)) values.push_back(t);
    for (const Crease& c : creases)
        values.insert(values.end(), static_cast<std::size_t>(knots.order() - 1), c.mean);
    std::ranges::sort(values);
    return Knots::general(knots.order(), std::move(values));
}

// Returns the places that cut each span with a crossing into `parts`.
std::vector<double> cuts(const Knots& knots, const std::vector<CreasePoint>& at, int axis,
                         int parts)
{
    const std::vector<double> breaks = knots.breaks();
    std::set<std::size_t> spans;
    for (const CreasePoint& c : at) {
        const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, c.uv[axis]);
        spans.insert(static_cast<std::size_t>(above - breaks.begin()) - 1);
    }
    std::vector<double> out;
    for (const std::size_t s : spans)
        for (int k = 1; k < parts; ++k)
            out.push_back(glm::mix(breaks[s], breaks[s + 1], static_cast<double>(k) / parts));
    return out;
}

// Moves a place on a line so that the nodes of creases lie on them; linear between creases.
double warped(double place, double line, const std::vector<Crease>& creases)
{
    double from = 0, to = 1, from_goes = 0, to_goes = 1;
    for (const Crease& c : creases) {
        if (c.mean <= place && c.mean >= from) from = c.mean, from_goes = c.at(line);
        if (c.mean >= place && c.mean <= to) to = c.mean, to_goes = c.at(line);
    }
    return to > from ? glm::mix(from_goes, to_goes, (place - from) / (to - from)) : from_goes;
}

// Lists the crossings, and the visible vertices of the scene near them.
std::vector<SceneSample> features_of(const std::vector<CreasePoint>& oblique, const View& view,
                                     const RayScene& scene, bool skip_back_faces)
{
    std::vector<SceneSample> out;
    std::set<std::pair<const RayScene::Entry*, std::uint32_t>> known;
    std::vector<SceneSample> vertices;
    std::vector<Ray> rays;
    std::vector<double> to;
    for (const CreasePoint& c : oblique) {
        out.push_back({c.p_world, c.uv});
        for (const Hit& side : c.sides)
            for (const RayScene::Entry& entry : scene.entries()) {
                if (entry.object != side.object) continue;
                const Mesh& mesh = entry.mesh->mesh();
                if (side.face < 0 || static_cast<std::size_t>(side.face) >= mesh.face_count())
                    continue;
                const auto face = static_cast<std::size_t>(side.face);
                for (std::uint32_t n = mesh.face_begin[face]; n < mesh.face_begin[face + 1]; ++n) {
                    const std::uint32_t v = mesh.corners[n];
                    if (!known.emplace(&entry, v).second) continue;
                    const glm::dvec3 p(entry.to_world *
                                       glm::dvec4(glm::dvec3(mesh.positions[v]), 1));
                    vertices.push_back({p, c.uv});
                    rays.push_back(view.ray_to(p));
                    to.push_back(glm::distance(rays.back().origin, p) * (1 - 1e-6));
                }
            }
    }
    const auto hidden = scene.hits(rays, skip_back_faces, to);
    for (std::size_t k = 0; k < vertices.size(); ++k)
        if (!hidden[k]) out.push_back(vertices[k]);
    return out;
}

// A SharpStrip is a strip whose surface has creases.
struct SharpStrip {
    std::array<Knots, 2> axes;
    std::vector<glm::dvec2> sites; // #nodes: the parameters of the strip as it was that they go to
    std::vector<std::optional<glm::dvec3>> on_crease; // #nodes: the point that they lie on
    std::vector<char> on_ridge;                       // #nodes
    std::vector<SceneSample> features;
};

// Probes the creases at the nodes that belong on them, a little to both sides.
void add_nodes_on(const std::array<std::vector<Crease>, 2>& creases, int axis,
                  const SharpStrip& strip, const StripChart& chart, std::vector<AskedCrease>& asked)
{
    const Knots& knots = strip.axes[static_cast<std::size_t>(axis)];
    const int columns = strip.axes[1].count();
    const double reach = 0.25 / static_cast<double>(chart.places(axis).size());
    for (const Crease& c : creases[static_cast<std::size_t>(axis)])
        for (std::size_t k = 0; k < strip.sites.size(); ++k) {
            const int node = static_cast<int>(k), at = axis == 0 ? node / columns : node % columns;
            if (!creased(knots, at) || std::abs(knots.greville(at) - c.mean) > 1e-9) continue;
            glm::dvec2 from = strip.sites[k], to = from;
            from[axis] = std::max(0.0, from[axis] - reach);
            to[axis] = std::min(1.0, to[axis] + reach);
            asked.push_back({from, to, axis, node});
        }
}

std::optional<SharpStrip> sharp_strip(const StripLayout& strip, const StripChart& chart,
                                      const View& view, const RayScene& scene,
                                      const PlacementParameters& p)
{
    std::vector<CreasePoint> all = crease_points(chart, scene, p.skip_back_faces);
    if (p.offset > 0) std::erase_if(all, [](const CreasePoint& c) { return !c.ridge; });
    const double old = static_cast<double>(strip.grid.rays.size());
    if (all.empty() || is_rough(all, chart)) return {};
    std::array<std::vector<Crease>, 2> creases;
    std::vector<char> taken(all.size(), 0);
    for (int axis = 0; axis < 2; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const std::vector<Crease> found = aligned(all, chart, axis);
        for (const Crease& c : found)
            for (const std::size_t k : c.used) taken[k] = 1;
        creases[a] = with_room(found, strip.axes[a]);
    }
    // Crossings of an aligned crease with lines along its own axis belong to it, too.
    std::vector<CreasePoint> oblique;
    for (std::size_t k = 0; k < all.size(); ++k) {
        bool of_aligned = taken[k];
        for (const auto& family : creases)
            for (const Crease& c : family) {
                const auto& places = chart.places(c.across);
                const double near = 1.0 / static_cast<double>(places.size());
                of_aligned = of_aligned ||
                             std::abs(all[k].uv[c.across] - c.at(all[k].uv[1 - c.across])) < near;
            }
        if (!of_aligned) oblique.push_back(all[k]);
    }

    SharpStrip out{strip.axes, {}, {}, {}, {}};
    for (const int parts : {4, 2, 1}) {
        double nodes = 1;
        for (int axis = 0; axis < 2; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            out.axes[a] =
                with_creases(strip.axes[a], creases[a], cuts(strip.axes[a], oblique, axis, parts));
            nodes *= out.axes[a].count();
        }
        if (nodes <= most_more * old) break;
    }
    if (out.axes == strip.axes && oblique.empty()) return {};
    out.features = features_of(oblique, view, scene, p.skip_back_faces);

    for (int i = 0; i < out.axes[0].count(); ++i)
        for (int j = 0; j < out.axes[1].count(); ++j) {
            const glm::dvec2 uv(out.axes[0].greville(i), out.axes[1].greville(j));
            out.sites.emplace_back(warped(uv.x, uv.y, creases[0]), warped(uv.y, uv.x, creases[1]));
        }
    // The lines differ from those on which the creases were found, so crossings are found again.
    out.on_crease.resize(out.sites.size());
    out.on_ridge.resize(out.sites.size(), 0);
    std::vector<AskedCrease> asked;
    for (int axis = 0; axis < 2; ++axis) add_nodes_on(creases, axis, out, chart, asked);
    for (const CreasePoint& c : crease_points(chart, asked, scene, p.skip_back_faces)) {
        const auto k = static_cast<std::size_t>(c.line);
        out.on_crease[k] = c.p_world;
        out.on_ridge[k] = c.ridge;
        out.sites[k] = c.uv;
    }
    return out;
}

} // namespace

std::optional<StripLayout> sharpened(const StripLayout& strip, const View& view,
                                     const RayScene& scene, const PlacementParameters& parameters)
{
    const StripChart chart(strip, view);
    std::optional<SharpStrip> sharp = sharp_strip(strip, chart, view, scene, parameters);
    if (!sharp) return {};
    StripLayout out = strip;
    RayGrid grid;
    grid.rows = sharp->axes[0].count();
    grid.columns = sharp->axes[1].count();
    for (int i = 0; i < grid.rows; ++i) {
        const Bracket at = bracket(chart.places(0), sharp->axes[0].greville(i));
        const auto first = static_cast<std::size_t>(at.first);
        grid.a.push_back(glm::mix(strip.grid.a[first], strip.grid.a[first + 1], at.share));
    }
    // Springs start again, because ridges no longer need them.
    out.s.assign(sharp->sites.size(), 0);
    for (std::size_t k = 0; k < sharp->sites.size(); ++k) {
        const auto& on = sharp->on_crease[k];
        grid.rays.push_back(on ? view.ray_to(*on) : chart.ray(sharp->sites[k]));
        grid.v.push_back(chart.value(strip.grid.v, sharp->sites[k]));
    }
    grid = met(std::move(grid), scene, parameters.skip_back_faces);
    for (std::size_t k = 0; k < grid.rays.size(); ++k) {
        if (!sharp->on_crease[k]) continue;
        grid.hit[k] = 1;
        grid.distance[k] = glm::distance(grid.rays[k].origin, *sharp->on_crease[k]);
    }
    out.grid = filled(std::move(grid), parameters.misses);
    out.axes = std::move(sharp->axes);
    out.features = std::move(sharp->features);
    out.on_ridge = std::move(sharp->on_ridge);
    return out;
}

} // namespace trivar
