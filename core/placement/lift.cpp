// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lift.h"

#include "core/base/parallel.h"
#include "core/placement/scene_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr int rays_a_cell = 4; // along each axis
constexpr int judging_rays_a_cell = 5;
constexpr int most_rounds = 12; // of lifting; lines of sight that are parallel need one
constexpr int most_judgements = 6;
constexpr double edge_on = 0.01;  // cosine between surface and ray below which steps mean nothing
constexpr double steep_scene = 2; // 1 / cosine to the ray from which sideways bends count
// Shares of the tolerance: what is let be, how far in front a lift ends, what the judges pass.
constexpr double let_be_share = 0.25, margin_share = 0.3, pass_share = 0.6;
// Samples further in front than this share of the deepest penetration, or of the tolerance, are
// not looked at again: lifting only moves the surface away from them.
constexpr double far_in_front = 4;

// How far the surface is in front of the sample (negative: behind), and where.
struct Gap {
    glm::dvec2 uv;
    double gap = 0;
    bool inside = false; // the strip covers the sample
};

// One step toward S(uv) = p - gap d, d the line of sight: exact to second order in the step.
Gap gap_at(const Surface<glm::dvec3>& s, const View& view, const SceneSample& sample)
{
    const auto jet = evaluate(s, sample.uv, 1);
    const glm::dvec3 toward = view.toward_eye(sample.p_world);
    const glm::dvec3 r = sample.p_world - jet.value;
    const double det = glm::dot(glm::cross(jet.u, jet.v), toward);
    const double area = glm::length(glm::cross(jet.u, jet.v));
    if (!(det > edge_on * area)) {
        // Seen from the edge or from behind there is no step to take, but the ray that gave the
        // sample went through this very point.
        const double gap = -glm::dot(r, toward);
        return {sample.uv, gap, glm::length(r + gap * toward) <= edge_on * std::abs(gap)};
    }
    const glm::dvec2 step(glm::dot(glm::cross(r, jet.v), toward) / det,
                          glm::dot(glm::cross(jet.u, r), toward) / det);
    const double gap = -glm::dot(glm::cross(jet.u, jet.v), r) / det;
    const glm::dvec2 uv = sample.uv + step;
    // The index finds the rim by chords; a bit outside, the tangent plane stands in.
    constexpr double rim = 2e-3;
    return {glm::clamp(uv, 0.0, 1.0), gap,
            glm::all(glm::greaterThanEqual(uv, glm::dvec2(-rim))) &&
                glm::all(glm::lessThanEqual(uv, glm::dvec2(1 + rim)))};
}

std::vector<Gap> gaps(const Surface<glm::dvec3>& s, const View& view,
                      std::vector<SceneSample>& samples)
{
    std::vector<Gap> out(samples.size());
    parallel_blocks(samples.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            out[i] = gap_at(s, view, samples[i]);
            samples[i].uv = out[i].uv;
        }
    });
    return out;
}

// What the camera sees behind points of the surface. Where it sees nothing there is no sample.
std::vector<SceneSample> seen_behind(const Surface<glm::dvec3>& s,
                                     const std::vector<glm::dvec2>& uv, const View& view,
                                     const Camera& camera, const RayScene& scene,
                                     bool skip_back_faces)
{
    std::vector<Ray> rays(uv.size());
    parallel_blocks(uv.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            rays[k] = ray_through(camera, view.project(evaluate(s, uv[k]).value).p_px);
    });
    const auto hits = scene.hits(rays, skip_back_faces);
    std::vector<SceneSample> out;
    for (std::size_t k = 0; k < uv.size(); ++k)
        if (hits[k]) out.push_back({hits[k]->p_world, uv[k], hits[k]->normal});
    return out;
}

// Both ends and, between them, `steps` points at equal distances, the first `shift` of it from 0.
std::vector<double> ticks(int steps, double shift)
{
    std::vector<double> out;
    for (int i = 0; i <= steps + 1; ++i)
        out.push_back(std::clamp((i - 1 + shift) / steps, 0.0, 1.0));
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<glm::dvec2> pairs(const std::vector<double>& us, const std::vector<double>& vs)
{
    std::vector<glm::dvec2> out;
    for (const double u : us)
        for (const double v : vs) out.emplace_back(u, v);
    return out;
}

// A control point that carries the surface at a sample, and how far it may be lifted for it.
struct Carrier {
    std::size_t k;
    double weight, room;
};

// Adds the least lifts, in squares, that raise the sample by `missing` within every room.
void share_out(double missing, std::vector<Carrier>& carriers, std::vector<double>& lift)
{
    for (bool full = true; full;) {
        full = false;
        double squares = 0;
        for (const Carrier& c : carriers) squares += c.weight * c.weight;
        std::erase_if(carriers, [&, still = missing](const Carrier& c) {
            if (still / squares * c.weight <= c.room) return false;
            lift[c.k] += c.room;
            missing -= c.weight * c.room;
            return full = true;
        });
        if (full) continue;
        for (const Carrier& c : carriers) lift[c.k] += missing / squares * c.weight;
    }
}

// Lifts the control points until every sample that is too far behind is the margin in front.
void lift_once(Surface<glm::dvec3>& s, const View& view, const std::vector<SceneSample>& samples,
               const std::vector<Gap>& at, double let_be, double margin, const LiftOptions& options)
{
    const double enough = options.clearance;
    std::vector<std::size_t> behind;
    for (std::size_t i = 0; i < at.size(); ++i)
        if (at[i].inside && at[i].gap < enough - let_be) behind.push_back(i);
    std::sort(behind.begin(), behind.end(), [&](std::size_t a, std::size_t b) {
        return at[a].gap != at[b].gap ? at[a].gap < at[b].gap : a < b;
    });
    std::vector<double> lift(s.points.size(), 0);
    std::vector<Carrier> carriers;
    for (const std::size_t i : behind) {
        const Basis a = basis(s.axes[0], samples[i].uv.x), b = basis(s.axes[1], samples[i].uv.y);
        const glm::dvec3 p = samples[i].p_world;
        const glm::dvec3 level = p + (enough + margin) * view.toward_eye(p);
        double missing = enough + margin - at[i].gap;
        carriers.clear();
        for (int k = 0; k < s.axes[0].order(); ++k)
            for (int l = 0; l < s.axes[1].order(); ++l) {
                const std::size_t n = s.index(a.first + k, b.first + l);
                const double weight =
                    a.value[static_cast<std::size_t>(k)] * b.value[static_cast<std::size_t>(l)];
                if (!(weight > 0)) continue;
                missing -= weight * lift[n];
                double room = std::numeric_limits<double>::infinity();
                if (options.never_overshoot) {
                    // Depth is linear in space, so convex sums of depths are those of points.
                    const double depth = glm::dot(s.points[n] - level, view.forward());
                    const double rise = -glm::dot(view.toward_eye(s.points[n]), view.forward());
                    room = std::max(0.0, depth / rise - lift[n]);
                }
                carriers.push_back({n, weight, room});
            }
        if (missing > 0) share_out(missing, carriers, lift);
    }
    for (std::size_t k = 0; k < s.points.size(); ++k)
        if (lift[k] > 0) s.points[k] += lift[k] * view.toward_eye(s.points[k]);
}

double most_behind(const std::vector<Gap>& at, double clearance)
{
    double worst = 0;
    for (const Gap& g : at)
        if (g.inside) worst = std::max(worst, clearance - g.gap);
    return worst;
}

// The samples that the surface covers and that are not far behind it.
std::vector<SceneSample> near_ones(const std::vector<SceneSample>& samples,
                                   const std::vector<Gap>& at, double margin)
{
    std::vector<SceneSample> out;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (at[i].inside && at[i].gap < margin) out.push_back(samples[i]);
    return out;
}

// The grid of the judging rays, and the least gap known in each of its quads.
struct Judges {
    std::vector<double> us, vs;
    std::vector<double> least; // (us - 1) x (vs - 1)
    std::vector<double> steep; // of each quad: the largest slope of the scene along the rays

    void note(const Gap& g, const glm::dvec3& normal, const View& view, const glm::dvec3& p_world,
              double enough)
    {
        if (!g.inside) return;
        // A scene that the rays graze turns a step of the surface sideways into a deep one.
        const double facing = std::abs(glm::dot(normal, view.toward_eye(p_world)));
        const double slope = normal == glm::dvec3(0) ? 0 : 1 / std::max(facing, 0.02);
        const auto cell = [](const std::vector<double>& x, double t) {
            const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, t);
            return static_cast<std::size_t>(above - x.begin()) - 1;
        };
        // A point on the line between two quads counts in both.
        for (const double du : {-1e-9, 1e-9})
            for (const double dv : {-1e-9, 1e-9}) {
                const std::size_t quad =
                    cell(us, g.uv.x + du) * (vs.size() - 1) + cell(vs, g.uv.y + dv);
                least[quad] = std::min(least[quad], g.gap - enough);
                steep[quad] = std::max(steep[quad], slope);
            }
    }
};

// Finer points inside those quads where the surface may sag behind the scene between places where
// it is in front: as many as bring the sag below the tolerance.
std::vector<glm::dvec2> suspicious(const Surface<glm::dvec3>& s, const View& view,
                                   const Judges& judges, double tolerance)
{
    const std::vector<double>&us = judges.us, &vs = judges.vs;
    std::vector<glm::dvec3> points;
    for (const glm::dvec2& uv : pairs(us, vs)) points.push_back(evaluate(s, uv).value);
    const std::vector<double> sag =
        sags(points, static_cast<int>(us.size()), static_cast<int>(vs.size()), view);
    // How far the surface is off its chords in any direction, within a quad.
    const auto bend = [&](std::size_t i, std::size_t j) {
        i = std::clamp<std::size_t>(i, 1, us.size() - 2);
        j = std::clamp<std::size_t>(j, 1, vs.size() - 2);
        const std::size_t k = i * vs.size() + j;
        return (glm::length(points[k - 1] + points[k + 1] - 2.0 * points[k]) +
                glm::length(points[k - vs.size()] + points[k + vs.size()] - 2.0 * points[k])) /
               8;
    };
    std::vector<glm::dvec2> out;
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
        for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
            double deepest = 0;
            const std::size_t k = i * vs.size() + j;
            for (const std::size_t c : {k, k + 1, k + vs.size(), k + vs.size() + 1})
                deepest = std::max(deepest, sag[c]);
            const std::size_t quad = i * (vs.size() - 1) + j;
            if (judges.steep[quad] > steep_scene) deepest += judges.steep[quad] * bend(i, j);
            if (judges.least[quad] - deepest >= -tolerance) continue;
            const double finer = std::clamp(std::sqrt(deepest / tolerance) + 1, 2.0, 16.0);
            const int n = static_cast<int>(finer);
            const glm::dvec2 lo(us[i], vs[j]), size(us[i + 1] - us[i], vs[j + 1] - vs[j]);
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b)
                    out.push_back(lo + size * (glm::dvec2(a, b) + 0.5) / static_cast<double>(n));
        }
    return out;
}

} // namespace

Lifted lifted(Surface<glm::dvec3> contact, const Camera& camera, const RayScene& scene,
              const LiftOptions& options)
{
    const View view(camera);
    const glm::ivec2 cells(contact.axes[0].count() - 1, contact.axes[1].count() - 1);
    const double let_be = let_be_share * options.tolerance, enough = options.clearance;
    Lifted out{std::move(contact)};
    const auto see = [&](const std::vector<glm::dvec2>& uv) {
        return seen_behind(out.contact, uv, view, camera, scene, options.skip_back_faces);
    };

    StripIndex strip(out.contact, view, rays_a_cell * cells);
    const NearScene near_scene(scene, view, strip, options.skip_back_faces);
    const auto vertices_and_edges = [&] {
        std::vector<SceneSample> samples = near_scene.samples(strip, let_be);
        // The index guesses the parameters within a part of a quad; the gap wants them closer.
        gaps(out.contact, view, samples);
        return samples;
    };

    std::vector<SceneSample> samples = vertices_and_edges();
    std::vector<SceneSample> rays =
        see(pairs(ticks(rays_a_cell * cells.x, 0), ticks(rays_a_cell * cells.y, 0)));
    for (const Gap& g : gaps(out.contact, view, rays))
        out.largest_gap = std::max(out.largest_gap, g.gap);
    samples.insert(samples.end(), rays.begin(), rays.end());

    for (int judgement = 0;; ++judgement) {
        std::vector<Gap> at = gaps(out.contact, view, samples);
        const double margin = far_in_front * std::max(most_behind(at, enough), options.tolerance);
        samples = near_ones(samples, at, enough + margin);
        const int rounds_before = out.rounds;
        for (int round = 0; round < most_rounds; ++round) {
            at = gaps(out.contact, view, samples);
            if (most_behind(at, enough) <= let_be) break;
            lift_once(out.contact, view, samples, at, let_be, margin_share * options.tolerance,
                      options);
            ++out.rounds;
        }

        // Elsewhere each time: a second look at the same places would find nothing.
        const double shift = 0.37 + 0.19 * judgement;
        Judges judges{ticks(judging_rays_a_cell * cells.x, shift),
                      ticks(judging_rays_a_cell * cells.y, shift),
                      {},
                      {}};
        judges.least.assign((judges.us.size() - 1) * (judges.vs.size() - 1), 1e300);
        judges.steep.assign(judges.least.size(), 0);
        std::vector<SceneSample> judging;
        std::vector<Gap> judged;
        const auto judge = [&](std::vector<SceneSample> more) {
            const std::vector<Gap> found = gaps(out.contact, view, more);
            for (std::size_t i = 0; i < found.size(); ++i)
                judges.note(found[i], more[i].normal, view, more[i].p_world, enough);
            judged.insert(judged.end(), found.begin(), found.end());
            judging.insert(judging.end(), more.begin(), more.end());
        };
        judge(see(pairs(judges.us, judges.vs)));
        // Where it was lifted it bends otherwise, and edges want points in other places.
        if (out.rounds > rounds_before) strip = StripIndex(out.contact, view, rays_a_cell * cells);
        judge(vertices_and_edges());
        judge(see(suspicious(out.contact, view, judges, let_be)));
        out.penetration = most_behind(judged, enough);
        if (out.penetration <= pass_share * options.tolerance || judgement == most_judgements)
            return out;
        const std::vector<SceneSample> found =
            near_ones(judging, judged, enough + options.tolerance);
        samples.insert(samples.end(), found.begin(), found.end());
    }
}

} // namespace trivar
