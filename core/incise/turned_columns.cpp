// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/turned_columns.h"

#include "core/base/smooth_step.h"
#include "core/base/unit.h"
#include "core/incise/slit_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

constexpr double smoothed_over = 0.3, round_smoothed_over = 0.15; // of the length of a run, a loop
constexpr double seen_enough = 0.05; // cosine with the faces round a column that leans
constexpr double less_leaning = 0.8; // the next lean to try
constexpr int most_leans = 16;
// Over so much of a run its columns turn, in edges of the skin and in depths times the turn.
constexpr double edges_to_turn = 1.5, depths_to_turn = 2;
constexpr double apart_enough = 0.1; // ratio of eigenvalues: cuts that meet at an angle

// The length of the run for which each of its points stands.
std::vector<double> lengths_of_points(const SlitRun& run)
{
    std::vector<double> out(run.last + 1, 0.0);
    for (std::size_t i = 0; i < run.last; ++i)
        for (const std::size_t k : {i, i + 1}) out[k] += (run.at[i + 1].s - run.at[i].s) / 2;
    return out;
}

// The mean directions round each point of a run, or that of all.
std::vector<glm::dvec3> smoothed_directions(const SlitRun& run, bool parallel,
                                            const SlitDrawing& drawing, const Inward& inward)
{
    const std::vector<double> lengths = lengths_of_points(run);
    std::vector<glm::dvec3> own, out;
    for (std::size_t i = 0; i <= run.last; ++i)
        own.push_back(unit_or_zero(inward.outward(drawing.point(run.at[i].point))));
    const auto mean = [&](const auto& weight) { // weight(k)
        glm::dvec3 sum(0);
        for (std::size_t k = 0; k <= run.last; ++k) sum += lengths[k] * weight(k) * own[k];
        return unit_or_zero(sum);
    };
    if (parallel) return std::vector(run.last + 1, mean([](std::size_t) { return 1.0; }));
    const double radius = (run.closed() ? round_smoothed_over : smoothed_over) * run.length;
    const auto place = [&](std::size_t i) { return drawing.position(run.at[i].point); };
    for (std::size_t i = 0; i <= run.last; ++i)
        out.push_back(mean([&](std::size_t k) { // by place, as a loop may come near itself
            const double x = std::min(1.0, glm::distance(place(i), place(k)) / radius);
            return (1 - x * x) * (1 - x * x);
        }));
    return out;
}

// A Lean holds the directions to the left of the cuts that meet at a point, and the tangents of
// their angles.
struct Lean {
    std::uint32_t point;
    std::vector<std::pair<glm::dvec3, double>> cuts = {};
};

// The offset v, across `up`, with dot(v, left) = tangent for each cut, in the least-squares sense;
// along directions that the cuts say little of, none.
glm::dvec3 offset_of(const Lean& lean, const glm::dvec3& up)
{
    const glm::dvec3 any = std::abs(up.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(up, any)), y = glm::cross(up, x);
    double xx = 0, xy = 0, yy = 0;
    glm::dvec2 b(0);
    for (const auto& [left, tangent] : lean.cuts) {
        const glm::dvec2 l(glm::dot(left, x), glm::dot(left, y));
        xx += l.x * l.x;
        xy += l.x * l.y;
        yy += l.y * l.y;
        b += tangent * l;
    }
    const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    const glm::dvec2 first(std::cos(angle), std::sin(angle)), second(-first.y, first.x);
    glm::dvec2 v(0);
    if (mean + half > 0) v += glm::dot(first, b) / (mean + half) * first;
    const double ratio = mean + half > 0 ? (mean - half) / (mean + half) : 0;
    if (ratio > 0) {
        v += smooth_step(ratio / apart_enough) * glm::dot(second, b) / (mean - half) * second;
    }
    return v.x * x + v.y * y;
}

// The offsets of one run's columns by which its walls lean, per depth and by point of the run.
class RunOffsets {
public:
    RunOffsets(const SlitRun& run, const SlitDrawing& drawing, const Inward& inward,
               const Incision& incision)
        : run_(run),
          tangent_(std::tan(incision.lean_deg * std::numbers::pi / 180)),
          depth_(incision.depth),
          edge_(drawing.skin().usual_edge())
    {
        const SlitCurve curve(run, drawing, inward);
        for (std::size_t i = 0; i <= run.last; ++i) left_.push_back(curve.left(run.at[i].s));
        const std::vector<double> lengths = lengths_of_points(run);
        const double radius = radius_for(tangent_);
        for (std::size_t i = 0; i <= run.last; ++i) {
            glm::dvec3 sum(0);
            double weights = 0;
            for (std::size_t k = 0; tangent_ != 0 && k <= run.last; ++k) {
                const double w = near(i, k, radius) * lengths[k];
                weights += w;
                sum += w * left_[k];
            }
            own_.push_back(weights > 0 ? tangent_ / weights * sum : glm::dvec3(0));
        }
        all_ = own_;
    }
    double tangent() const { return tangent_; }
    const glm::dvec3& left(std::size_t i) const { return left_[i]; }
    const glm::dvec3& operator[](std::size_t i) const { return all_[i]; }
    // Adds another cut's offset at a crossing; it fades with the distance from there.
    void meet(std::size_t at, const glm::dvec3& offset)
    {
        const glm::dvec3 more = offset - own_[at];
        const double radius = radius_for(glm::length(more));
        for (std::size_t i = 0; i <= run_.last; ++i) all_[i] += near(at, i, radius) * more;
    }

private:
    // Such that columns do not come too near each other.
    double radius_for(double offset) const
    {
        return std::max(edges_to_turn * edge_, depths_to_turn * std::abs(offset) * depth_);
    }
    double near(std::size_t i, std::size_t k, double radius) const
    {
        double away = std::abs(run_.at[i].s - run_.at[k].s);
        if (run_.closed()) away = std::min(away, run_.length - away);
        const double x = std::min(1.0, away / radius);
        return (1 - x * x) * (1 - x * x);
    }

    const SlitRun& run_;
    double tangent_, depth_, edge_;
    std::vector<glm::dvec3> left_, own_, all_;
};

// Returns the offset per depth of each point that leans.
std::vector<std::pair<std::uint32_t, glm::dvec3>> offsets_of(const std::vector<SlitRun>& runs,
                                                             const SlitDrawing& drawing,
                                                             const Inward& inward,
                                                             std::span<const Incision> incisions)
{
    std::vector<std::pair<std::uint32_t, glm::dvec3>> out;
    if (std::ranges::none_of(
            runs, [&](const SlitRun& run) { return incisions[run.incision].lean_deg != 0; }))
        return out;
    std::vector<RunOffsets> of_run;
    struct Visit {
        std::size_t run, at;
    };
    KeyNumbers number;
    std::vector<std::uint32_t> points;
    std::vector<std::vector<Visit>> visits;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        of_run.emplace_back(runs[r], drawing, inward, incisions[runs[r].incision]);
        for (std::size_t i = runs[r].closed() ? 1 : 0; i <= runs[r].last; ++i) {
            const auto [n, fresh] = number.number(runs[r].at[i].point);
            if (fresh) {
                points.push_back(runs[r].at[i].point);
                visits.emplace_back();
            }
            visits[n].push_back({r, i});
        }
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (visits[n].size() < 2) continue;
        Lean lean{points[n]};
        for (const Visit& v : visits[n])
            lean.cuts.emplace_back(of_run[v.run].left(v.at), of_run[v.run].tangent());
        if (std::ranges::all_of(lean.cuts, [](const auto& cut) { return cut.second == 0; }))
            continue;
        const glm::dvec3 up = unit_or_zero(inward.outward(drawing.point(points[n])));
        if (up == glm::dvec3(0)) continue;
        const glm::dvec3 offset = offset_of(lean, up);
        for (const Visit& v : visits[n]) of_run[v.run].meet(v.at, offset);
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
        glm::dvec3 sum(0);
        for (const Visit& v : visits[n]) sum += of_run[v.run][v.at];
        if (sum != glm::dvec3(0))
            out.emplace_back(points[n], sum / static_cast<double>(visits[n].size()));
    }
    return out;
}

} // namespace

SlitColumns columns_of(const std::vector<SlitRun>& runs, const std::vector<char>& parallel,
                       const SlitDrawing& drawing, const Inward& inward,
                       std::span<const Incision> incisions)
{
    SlitColumns out(drawing, inward);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (runs[k].kind != SlitRun::Kind::through) continue;
        const std::vector<glm::dvec3> directions =
            smoothed_directions(runs[k], parallel[k], drawing, inward);
        for (std::size_t i = 0; i <= runs[k].last; ++i)
            out.turn(runs[k].at[i].point, directions[i]);
    }
    const SlitSkin& skin = drawing.skin();
    for (const auto& [point, per_depth] : offsets_of(runs, drawing, inward, incisions)) {
        const glm::dvec3 straight = out.outward(point);
        const double length = glm::length(straight);
        if (!(length > 0)) continue;
        glm::dvec3 offset = length * per_depth;
        const auto seen = [&, at = drawing.point(point)] {
            const glm::dvec3 outward = glm::normalize(straight - offset);
            return std::ranges::all_of(triangles_round(skin, at), [&](std::uint32_t t) {
                return glm::dot(unit_or_zero(skin.area_normal(t)), outward) > seen_enough;
            });
        };
        for (int i = 0; i < most_leans && !seen(); ++i) offset *= less_leaning;
        if (seen()) out.turn(point, straight - offset);
    }
    return out;
}

} // namespace trivar
