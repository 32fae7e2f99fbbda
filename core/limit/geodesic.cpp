// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/geodesic.h"

#include "core/limit/tangent.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int most_creases = 16;    // that one way goes over
constexpr int most_shortenings = 3; // of a step that a crease or border stops
// A step that is longer than this, in charts, is made in space: over several charts their
// coordinates bend more than the surface does.
constexpr double longest_in_charts = 0.5;
constexpr double on_edge_share = 1e-9; // of a step: what is left of it at an edge counts as nothing

// The rates at which the state of a ray changes with its length.
struct Rates {
    glm::dvec2 uv{0};
    glm::dvec3 p{0}, direction{0};
    double spread = 0, spread_rate = 0;
};

// A RayState is the state of a ray; `after` advances it by a step of the given length at these
// rates.
struct RayState {
    glm::dvec3 direction;
    double spread, spread_rate;
    RayState after(const Rates& r, double length) const
    {
        return {direction + length * r.direction, spread + length * r.spread,
                spread_rate + length * r.spread_rate};
    }
};

// u' and v' are the tangent's coordinates; the tangent turns toward the normal by the curvature
// II(u', v') along it; j'' = -K j.
Rates rates_at(const LimitJet& jet, const RayState& state)
{
    const SurfaceFrame frame = frame_of(jet);
    const glm::dvec3 t = state.direction - glm::dot(state.direction, frame.normal) * frame.normal;
    const glm::dvec2 d = in_chart(jet, t);
    const double bend = glm::dot(jet.uu, frame.normal) * d.x * d.x +
                        2 * glm::dot(jet.uv, frame.normal) * d.x * d.y +
                        glm::dot(jet.vv, frame.normal) * d.y * d.y;
    return {d, t, bend * frame.normal, state.spread_rate, -frame.k1 * frame.k2 * state.spread};
}

Rates mean_of(const std::array<Rates, 4>& k) // by Simpson's rule, as Runge and Kutta weigh them
{
    const auto mean = [&](auto member) {
        return (k[0].*member + 2.0 * (k[1].*member) + 2.0 * (k[2].*member) + k[3].*member) / 6.0;
    };
    return {mean(&Rates::uv), mean(&Rates::p), mean(&Rates::direction), mean(&Rates::spread),
            mean(&Rates::spread_rate)};
}

constexpr std::array<double, 4> stage_share{0, 0.5, 0.5, 1};

class Tracer {
public:
    Tracer(const LimitSurface& surface, GeodesicRay& ray) : surface_(surface), ray_(ray) {}

    // Makes one step of at most the given length; returns its length. `edge` names the crease or
    // border that stopped it.
    double step(double length, int& edge)
    {
        const double made = in_charts(length, edge);
        return made > 0 ? made : in_space(length, edge);
    }

    // The crease or border on which the ray is and over which it leads; -1: none. A step that ends
    // a hair before an edge would otherwise be followed by ever shorter ones.
    int edge_ahead() const
    {
        constexpr double hair = 1e-9; // of a chart
        const glm::dvec2 d = in_chart(surface_.jet(ray_.at), ray_.direction);
        for (int e = 0; e < 4; ++e) {
            const double before = glm::dot(chart_corner(e) - ray_.at.uv, out_of_edge(e));
            if (!(before < hair) || !(glm::dot(d, out_of_edge(e)) > 0)) continue;
            if (surface_.net().is_crease(ray_.at.chart, e) ||
                surface_.net().across(ray_.at.chart, e).chart == ChartNet::none)
                return e;
        }
        return -1;
    }

    // Over a crease the direction turns about the edge, as if both sides were unfolded. False at a
    // border.
    bool over_crease(int edge)
    {
        if (ray_.creases >= most_creases) return false;
        if (surface_.net().across(ray_.at.chart, edge).chart == ChartNet::none) return false;
        const glm::dvec3 before = frame_of(surface_.jet(ray_.at)).normal;
        ray_.at = surface_.net().beyond(ray_.at, edge);
        const glm::dvec3 after = frame_of(surface_.jet(ray_.at)).normal;
        const glm::dvec3 turned =
            in_tangent_plane(turned_from_to(before, after, ray_.direction), after);
        if (turned == glm::dvec3(0)) return false;
        ray_.direction = turned;
        ++ray_.creases;
        return true;
    }

private:
    RayState state() const { return {ray_.direction, ray_.spread, ray_.spread_rate}; }

    void arrive(const ChartPlace& at, const Rates& mean, double length, const glm::dvec3& normal)
    {
        const RayState there = state().after(mean, length);
        ray_.at = at;
        const glm::dvec3 direction = in_tangent_plane(there.direction, normal);
        if (direction != glm::dvec3(0)) ray_.direction = direction;
        ray_.spread = there.spread;
        ray_.spread_rate = there.spread_rate;
    }

    // With the coordinates as the state. Right only where all charts that it touches are regular;
    // otherwise it makes nothing and returns 0.
    double in_charts(double length, int& edge)
    {
        if (!surface_.is_regular(ray_.at.chart)) return 0;
        ChartNet::Walk stopped; // a longer attempt
        for (int attempt = 0;; ++attempt) {
            std::array<Rates, 4> k;
            for (std::size_t i = 0; i < 4; ++i) {
                const Rates before = i > 0 ? k[i - 1] : Rates{};
                const double part = stage_share[i] * length;
                if (length * glm::length(before.uv) > longest_in_charts) return 0;
                const ChartNet::Walk walk = surface_.net().walk(ray_.at, part * before.uv, false);
                if (!surface_.is_regular(walk.at.chart)) return 0;
                k[i] = rates_at(surface_.jet(walk.at), state().after(before, part));
                k[i].uv = quarter_turned(k[i].uv, -walk.turns); // as the first chart has it
            }
            const Rates mean = mean_of(k);
            ChartNet::Walk walk = surface_.net().walk(ray_.at, length * mean.uv, false);
            if (!surface_.is_regular(walk.at.chart)) return 0;
            if (walk.left > on_edge_share && attempt < most_shortenings) {
                length *= std::max(1 - walk.left, 1e-6); // so that it ends on the edge
                stopped = walk;
                continue;
            }
            if (walk.edge < 0 && stopped.edge >= 0 && walk.at.chart == stopped.at.chart &&
                is_near(walk.at.uv, stopped.edge)) {
                walk.edge = stopped.edge;
                walk.at.uv = onto(walk.at.uv, walk.edge);
            }
            arrive(walk.at, mean, length, frame_of(surface_.jet(walk.at)).normal);
            edge = walk.edge;
            return length;
        }
    }

    // With the point in space as the state and its foot point for the coordinates: right also where
    // the lines of the coordinates have kinks.
    double in_space(double length, int& edge)
    {
        const LimitJet start = surface_.jet(ray_.at);
        const double tolerance = 1e-6 * length;
        FootPoint stopped; // where a longer attempt met an edge
        for (int attempt = 0;; ++attempt) {
            std::array<Rates, 4> k{rates_at(start, state())};
            FootPoint foot{ray_.at, start};
            for (std::size_t i = 1; i < 4; ++i) {
                const double part = stage_share[i] * length;
                foot = foot_point(surface_, foot.at, start.p + part * k[i - 1].p, tolerance);
                k[i] = rates_at(foot.jet, state().after(k[i - 1], part));
            }
            const Rates mean = mean_of(k);
            const glm::dvec3 p = start.p + length * mean.p;
            foot = foot_point(surface_, foot.at, p, tolerance);
            if (foot.edge >= 0 && attempt < most_shortenings) {
                const double over = too_far_beyond(foot, p, state().after(mean, length).direction);
                if (over > 1e-7 * length && over < length) {
                    length -= over;
                    stopped = foot;
                    continue;
                }
            }
            if (foot.edge < 0 && stopped.edge >= 0 && foot.at.chart == stopped.at.chart &&
                is_near(foot.at.uv, stopped.edge)) {
                foot.edge = stopped.edge;
                foot.at.uv = onto(foot.at.uv, foot.edge);
            }
            arrive(foot.at, mean, length, frame_of(foot.jet).normal);
            edge = foot.edge;
            return length;
        }
    }

    // Returns by how much a step was too long that ended at p beyond an edge.
    static double too_far_beyond(const FootPoint& foot, const glm::dvec3& p, const glm::dvec3& t)
    {
        const glm::dvec2 a = along_edge(foot.edge), o = out_of_edge(foot.edge);
        const glm::dvec3 side = glm::normalize(a.x * foot.jet.u + a.y * foot.jet.v);
        glm::dvec3 out = o.x * foot.jet.u + o.y * foot.jet.v;
        out = glm::normalize(out - glm::dot(out, side) * side);
        return glm::dot(p - foot.jet.p, out) / std::max(0.05, glm::dot(t, out));
    }

    // A step that was shortened so as to end on an edge and ended a hair before it ends on it.
    static bool is_near(const glm::dvec2& uv, int edge)
    {
        constexpr double hair = 1e-3; // of a chart
        return glm::dot(uv - chart_corner(edge), out_of_edge(edge)) >= -hair;
    }
    static glm::dvec2 onto(const glm::dvec2& uv, int edge)
    {
        const double t = glm::dot(uv - chart_corner(edge), along_edge(edge));
        return on_edge(edge, std::clamp(t, 0.0, 1.0));
    }

    const LimitSurface& surface_;
    GeodesicRay& ray_;
};

} // namespace

void extend(const LimitSurface& surface, GeodesicRay& ray, double length, int steps)
{
    Tracer tracer(surface, ray);
    const double tiny = 1e-9 * length, step = length / steps;
    double rest = length;
    for (int made = 0; rest > tiny && made < 4 * steps + 32; ++made) {
        int edge = tracer.edge_ahead();
        if (edge < 0) rest -= tracer.step(std::min(step, rest), edge);
        if (edge >= 0 && rest > tiny && !tracer.over_crease(edge)) break;
    }
    ray.left += rest > tiny ? rest : 0;
}

GeodesicRay geodesic(const LimitSurface& surface, const ChartPlace& start, const glm::dvec3& way,
                     int steps)
{
    GeodesicRay ray{start};
    const double length = glm::length(way);
    if (!(length > 0)) return ray;
    ray.direction = way / length;
    extend(surface, ray, length, steps);
    return ray;
}

int steps_from(const LimitSurface& surface, const ChartPlace& start, double length)
{
    const SurfaceFrame frame = frame_of(surface.jet(start));
    const double turn = length * std::max(std::abs(frame.k1), std::abs(frame.k2));
    if (!(turn < 2)) return 8;
    return std::max(1, static_cast<int>(std::ceil(4 * turn)));
}

} // namespace trivar
