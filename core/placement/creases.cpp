// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/creases.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

const double cos_crease = std::cos(glm::radians(25.0));
constexpr double off_share = 0.05; // of an interval's length that its middle may lie off
constexpr int most_halvings = 4;
// The planes of both sides give the exact place. Touching boxes differ by roundings.
constexpr int bisections = 12;
// Share of an interval: closer sides are a crease, others a cliff
constexpr double seen_together = 1e-3;

struct Probe {
    glm::dvec2 uv{0};
    Ray ray{};
    std::optional<Hit> hit;
};

std::vector<Probe> probes(const StripChart& chart, const std::vector<glm::dvec2>& uv,
                          const RayScene& scene, bool skip_back_faces)
{
    std::vector<Ray> rays;
    rays.reserve(uv.size());
    for (const glm::dvec2& at : uv) rays.push_back(chart.ray(at));
    std::vector<std::optional<Hit>> hits = scene.hits(rays, skip_back_faces);
    std::vector<Probe> out(uv.size());
    for (std::size_t k = 0; k < uv.size(); ++k) {
        std::optional<Hit>& hit = hits[k];
        if (hit && std::abs(glm::dot(hit->normal, rays[k].direction)) < grazing) hit.reset();
        if (hit && hit->back_face) hit->normal = -hit->normal;
        out[k] = {uv[k], rays[k], std::move(hit)};
    }
    return out;
}

// An Interval is a part of a grid line; axis and line are as in CreasePoint.
struct Interval {
    Probe a, b;
    int axis = 0, line = -1;
    glm::dvec3 way{0};         // from a to b, when it was found to hold a crease
    glm::dvec3 rays_normal{0}; // of the plane that the rays between its ends lie in, about
};

bool kinked(const Probe& a, const Probe& b)
{
    return glm::dot(a.hit->normal, b.hit->normal) < cos_crease;
}

bool middle_off(const Interval& i, const Probe& middle)
{
    const glm::dvec3 between = (i.a.hit->p_world + i.b.hit->p_world) / 2.0;
    const double off = glm::dot(middle.hit->p_world - between, middle.ray.direction);
    return std::abs(off) > off_share * glm::distance(i.a.hit->p_world, i.b.hit->p_world);
}

std::vector<Probe> middles(const std::vector<Interval>& intervals, const StripChart& chart,
                           const RayScene& scene, bool skip_back_faces)
{
    std::vector<glm::dvec2> uv;
    uv.reserve(intervals.size());
    for (const Interval& i : intervals) uv.push_back((i.a.uv + i.b.uv) / 2.0);
    return probes(chart, uv, scene, skip_back_faces);
}

// Intersects the planes of both sides and the plane of the rays between them.
glm::dvec3 crease_point(const Interval& i)
{
    const Hit &a = *i.a.hit, &b = *i.b.hit;
    const glm::dvec3& m = i.rays_normal;
    const glm::dmat3 planes = glm::transpose(glm::dmat3(a.normal, b.normal, m));
    const double det = glm::determinant(planes);
    if (!(std::abs(det) > 1e-12 * glm::length(m))) return a.p_world;
    const glm::dvec3 p =
        glm::inverse(planes) * glm::dvec3(glm::dot(a.normal, a.p_world),
                                          glm::dot(b.normal, b.p_world), glm::dot(m, a.p_world));
    return glm::distance(p, a.p_world) < seen_together * glm::length(i.way) ? p : a.p_world;
}

std::vector<CreasePoint> crossings(std::vector<Interval> found, const StripChart& chart,
                                   const RayScene& scene, bool skip_back_faces)
{
    const auto off_plane = [](const Probe& of, const Probe& p) {
        return std::abs(glm::dot(p.hit->p_world - of.hit->p_world, of.hit->normal));
    };
    for (Interval& i : found) {
        i.way = i.b.hit->p_world - i.a.hit->p_world;
        i.rays_normal = glm::cross(i.a.ray.direction, i.way);
    }
    for (int step = 0; step < bisections; ++step) {
        std::vector<Probe> middle = middles(found, chart, scene, skip_back_faces);
        for (std::size_t k = 0; k < found.size(); ++k)
            if (middle[k].hit) {
                Interval& i = found[k];
                Probe& same = off_plane(i.a, middle[k]) <= off_plane(i.b, middle[k]) ? i.a : i.b;
                same = std::move(middle[k]);
            }
    }
    std::vector<CreasePoint> out;
    for (const Interval& i : found) {
        const Hit &a = *i.a.hit, &b = *i.b.hit;
        const bool cliff = glm::distance(a.p_world, b.p_world) > seen_together * glm::length(i.way);
        if (cliff || !kinked(i.a, i.b)) continue;
        out.push_back({(i.a.uv + i.b.uv) / 2.0,
                       crease_point(i),
                       i.axis,
                       i.line,
                       {a, b},
                       glm::dot(b.normal - a.normal, i.way) > 0});
    }
    return out;
}

// Halves the intervals that may hold a crease; short ones are returned as they are.
std::vector<Interval> halved(std::vector<Interval> intervals, const StripChart& chart,
                             const RayScene& scene, bool skip_back_faces)
{
    for (int halving = 0; halving <= most_halvings; ++halving) {
        const std::vector<Probe> middle = middles(intervals, chart, scene, skip_back_faces);
        std::vector<Interval> next;
        for (std::size_t k = 0; k < intervals.size(); ++k) {
            Interval& i = intervals[k];
            if (!middle[k].hit) continue;
            const bool differ = i.a.hit->object != i.b.hit->object;
            if (!differ && !kinked(i.a, i.b) && !middle_off(i, middle[k])) continue;
            if (halving == most_halvings) {
                next.push_back(std::move(i));
            } else {
                next.push_back({i.a, middle[k], i.axis, i.line});
                next.push_back({middle[k], i.b, i.axis, i.line});
            }
        }
        intervals = std::move(next);
    }
    return intervals;
}

void add(std::vector<Interval>& to, const Probe& a, const Probe& b, int axis, std::size_t line)
{
    if (a.hit && b.hit) to.push_back({a, b, axis, static_cast<int>(line)});
}

// Adds intervals from the middle of a cell to the middles of its edges, if the middle of the cell
// is not between its corners.
void add_middles(std::vector<Interval>& to, const std::vector<Probe>& nodes,
                 const StripChart& chart, const RayScene& scene, bool skip_back_faces)
{
    const std::vector<double>&us = chart.places(0), &vs = chart.places(1);
    const auto node = [&](std::size_t i, std::size_t j) -> const Probe& {
        return nodes[i * vs.size() + j];
    };
    std::vector<glm::dvec2> uv;
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
        for (std::size_t j = 0; j + 1 < vs.size(); ++j)
            uv.push_back((node(i, j).uv + node(i + 1, j + 1).uv) / 2.0);
    const std::vector<Probe> middle = probes(chart, uv, scene, skip_back_faces);
    std::vector<std::size_t> off;
    std::vector<glm::dvec2> edges;
    for (std::size_t k = 0; k < middle.size(); ++k) {
        const std::size_t i = k / (vs.size() - 1), j = k % (vs.size() - 1);
        const std::array<const Probe*, 4> corners{&node(i, j), &node(i + 1, j), &node(i, j + 1),
                                                  &node(i + 1, j + 1)};
        glm::dvec3 between(0);
        bool all = middle[k].hit.has_value();
        for (const Probe* c : corners) {
            all = all && c->hit;
            if (c->hit) between += c->hit->p_world / 4.0;
        }
        if (!all) continue;
        const double size = glm::distance(corners[0]->hit->p_world, corners[3]->hit->p_world);
        if (!(std::abs(glm::dot(middle[k].hit->p_world - between, middle[k].ray.direction)) >
              off_share * size))
            continue;
        off.push_back(k);
        const glm::dvec2 half = (corners[3]->uv - corners[0]->uv) / 2.0;
        for (const glm::dvec2 way : {glm::dvec2(-1, 0), {1, 0}, {0, -1}, {0, 1}})
            edges.push_back(middle[k].uv + way * half);
    }
    const std::vector<Probe> ends = probes(chart, edges, scene, skip_back_faces);
    for (std::size_t k = 0; k < ends.size(); ++k)
        if (ends[k].hit) to.push_back({middle[off[k / 4]], ends[k], k % 4 < 2 ? 0 : 1, -1});
}

} // namespace

Bracket bracket(const std::vector<double>& places, double at)
{
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, at);
    const auto i = static_cast<std::size_t>(above - places.begin()) - 1;
    return {static_cast<int>(i),
            std::clamp((at - places[i]) / (places[i + 1] - places[i]), 0.0, 1.0)};
}

StripChart::StripChart(const StripLayout& strip, const View& view) : strip_(strip), view_(view)
{
    for (int axis = 0; axis < 2; ++axis) {
        const Knots& knots = strip.axes[static_cast<std::size_t>(axis)];
        for (int i = 0; i < knots.count(); ++i)
            places_[static_cast<std::size_t>(axis)].push_back(knots.greville(i));
    }
}

double StripChart::value(const std::vector<double>& of_nodes, glm::dvec2 uv) const
{
    const Bracket i = bracket(places_[0], uv.x), j = bracket(places_[1], uv.y);
    const auto at = [&](int a, int b) {
        return of_nodes[strip_.grid.index(i.first + a, j.first + b)];
    };
    return (at(0, 0) * (1 - j.share) + at(0, 1) * j.share) * (1 - i.share) +
           (at(1, 0) * (1 - j.share) + at(1, 1) * j.share) * i.share;
}

Ray StripChart::ray(glm::dvec2 uv) const
{
    const Bracket i = bracket(places_[0], uv.x);
    const auto first = static_cast<std::size_t>(i.first);
    const double a = strip_.grid.a[first] * (1 - i.share) + strip_.grid.a[first + 1] * i.share;
    return view_.ray(strip_.strip.at(a, value(strip_.grid.v, uv)));
}

std::vector<CreasePoint> crease_points(const StripChart& chart, const RayScene& scene,
                                       bool skip_back_faces)
{
    const std::vector<double>&us = chart.places(0), &vs = chart.places(1);
    std::vector<glm::dvec2> uv;
    for (const double u : us)
        for (const double v : vs) uv.emplace_back(u, v);
    const std::vector<Probe> nodes = probes(chart, uv, scene, skip_back_faces);
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < us.size(); ++i)
        for (std::size_t j = 0; j < vs.size(); ++j) {
            const std::size_t k = i * vs.size() + j;
            if (i + 1 < us.size()) add(intervals, nodes[k], nodes[k + vs.size()], 0, j);
            if (j + 1 < vs.size()) add(intervals, nodes[k], nodes[k + 1], 1, i);
        }
    add_middles(intervals, nodes, chart, scene, skip_back_faces);
    return crossings(halved(std::move(intervals), chart, scene, skip_back_faces), chart, scene,
                     skip_back_faces);
}

std::vector<CreasePoint> crease_points(const StripChart& chart,
                                       const std::vector<AskedCrease>& asked, const RayScene& scene,
                                       bool skip_back_faces)
{
    std::vector<glm::dvec2> uv;
    for (const AskedCrease& a : asked) uv.insert(uv.end(), {a.from, a.to});
    const std::vector<Probe> ends = probes(chart, uv, scene, skip_back_faces);
    std::vector<Interval> intervals;
    for (std::size_t k = 0; k < asked.size(); ++k)
        add(intervals, ends[2 * k], ends[2 * k + 1], asked[k].axis,
            static_cast<std::size_t>(asked[k].line));
    return crossings(std::move(intervals), chart, scene, skip_back_faces);
}

} // namespace trivar
