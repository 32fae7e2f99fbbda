// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lift.h"

#include "core/base/parallel.h"
#include "core/placement/strip_judge.h"
#include "core/placement/strip_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr double folding = 0.1; // cosine to the ray below which the strip may fold in the picture
// Number of rays along each axis of a cell seen edge-on, in each look and in the last one.
constexpr int rays_where_steep = 6, rays_in_last_look = 24;
constexpr int quads_a_cell = 2; // of the index, along each axis
constexpr int most_rounds = 12; // number of lifts; parallel lines of sight need one
constexpr int most_judgements = 12;
constexpr int most_looks_again = 5; // with rays, for one judgement
// Shares of the tolerance: depths that need no lift, the margin after a lift, and depths that the
// judge accepts.
constexpr double let_be_share = 0.25, margin_share = 0.3, pass_share = 0.75;

// A Carrier is a control point with its weight at a sample, and how far it may be lifted.
struct Carrier {
    std::size_t k;
    double weight, room;
};

// Adds the lifts of least squares that raise the sample by `missing` within the room of each
// carrier.
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
void lift_once(Surface<glm::dvec3>& s, const SurfaceTable& table, const View& view,
               const std::vector<SceneSample>& samples, const std::vector<Gap>& at, double let_be,
               double margin, const LiftOptions& options)
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
        const glm::dvec3 p = samples[i].p_world;
        const glm::dvec3 level = p + (enough + margin) * view.toward_eye(p);
        double missing = enough + margin - at[i].gap;
        carriers.clear();
        table.each_weight(at[i].uv, [&](std::size_t k, double weight) {
            if (!(weight > 0)) return;
            missing -= weight * lift[k];
            double room = std::numeric_limits<double>::infinity();
            if (options.never_overshoot) {
                // Depth is linear in space, so it commutes with convex sums.
                const double depth = glm::dot(s.points[k] - level, view.forward());
                const double rise = -glm::dot(view.toward_eye(s.points[k]), view.forward());
                room = std::max(0.0, depth / rise - lift[k]);
            }
            carriers.push_back({k, weight, room});
        });
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

} // namespace

LiftedSurface lifted(Surface<glm::dvec3> contact, const Camera& camera, const RayScene& scene,
                     const LiftOptions& options)
{
    const View view(camera);
    const double enough = options.clearance, pass = pass_share * options.tolerance;
    const JudgeOptions judging{enough, let_be_share * options.tolerance, pass};
    LiftedSurface out{std::move(contact)};
    const SurfaceTable table(out.contact);
    const StripCut cut{table.cells(), quads_a_cell};

    // Lifts the surface at samples that are behind and marks the moved control points; false if no
    // lift helps any more. Samples in front stay in front.
    std::vector<char> moved(out.contact.points.size(), 0);
    const auto rise = [&](std::vector<SceneSample> samples) {
        const std::vector<glm::dvec3> before = out.contact.points;
        const int rounds_before = out.rounds;
        for (int round = 0; round < most_rounds; ++round) {
            const std::vector<Gap> at = gaps(table, view, samples);
            if (most_behind(at, enough) <= judging.let_be) break;
            lift_once(out.contact, table, view, samples, at, judging.let_be,
                      margin_share * options.tolerance, options);
            ++out.rounds;
        }
        for (std::size_t k = 0; k < before.size(); ++k)
            moved[k] = moved[k] || before[k] != out.contact.points[k];
        return out.rounds > rounds_before;
    };
    const auto take_moved = [&] {
        std::vector<char> corners = table.touched(cut.quads(), moved);
        std::fill(moved.begin(), moved.end(), 0);
        return corners;
    };
    double let_be = 0; // largest depth found that needs no lift
    RayLook look{.skip_back_faces = options.skip_back_faces};
    // Casts rays, the fastest way, until they find nothing that a lift could repair. Returns the
    // rest, and marks moved control points as changed.
    std::vector<char> changed;
    const auto look_and_rise = [&](std::vector<char> where, int many_rays) {
        look.where_steep = many_rays;
        for (int again = 0;; ++again) {
            Judgement found = seen_behind(table, cut, where, look, view, scene, judging).found;
            ++look.turn;
            let_be = std::max(let_be, std::min(found.worst, judging.let_be));
            if (again == most_looks_again || !rise(found.behind)) return found;
            where = take_moved();
            for (std::size_t k = 0; k < where.size(); ++k) changed[k] = changed[k] || where[k];
        }
    };

    const std::vector<char> everywhere(cut.corners(), 1), nowhere(cut.corners(), 0);
    look.beyond = true;
    SeenBehind first = seen_behind(table, cut, everywhere, look, view, scene, judging);
    out.largest_gap = first.largest_gap;
    look.beyond = false;
    rise(std::move(first.found.behind));
    take_moved();
    changed = everywhere;
    Judgement found = look_and_rise(everywhere, rays_where_steep);
    StripIndex strip(table, view, cut.quads());
    const NearScene near = near_scene(scene, view, strip, options.skip_back_faces);
    StripJudge judge(table, view, near, judging);
    int rays = rays_where_steep;
    for (int judgement = 0;; ++judgement) {
        found.add(judge.judge(strip));
        out.penetration = std::max(found.worst, let_be);
        if (judgement == most_judgements) return out;
        if (out.penetration > pass) {
            let_be = std::max(let_be, std::min(found.worst, judging.let_be));
            if (!rise(std::move(found.behind))) return out;
            changed = take_moved();
            found = look_and_rise(changed, rays);
        } else {
            // Looks once more, closely, where the strip may fold in the picture, because its layers
            // hide each other from the index.
            if (rays == rays_in_last_look) return out;
            rays = rays_in_last_look;
            changed = nowhere;
            found = look_and_rise(steep_corners(table, cut, everywhere, view, folding), rays);
            if (changed == nowhere) {
                out.penetration = std::max(out.penetration, found.worst);
                return out;
            }
        }
        // In perspective a lift moves the strip a little in the picture.
        strip = StripIndex(table, view, cut.quads());
        strip.mark_changed(changed);
    }
}

} // namespace trivar
