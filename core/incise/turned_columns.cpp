// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/turned_columns.h"

#include "core/incise/cut_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

constexpr double smoothed_over = 0.3; // of a run's length
constexpr double seen_enough = 0.05;  // cosine with the faces round a column that leans
constexpr double less_leaning = 0.8;  // the next lean to try
constexpr int most_leans = 16;
constexpr double apart_enough = 0.1; // ratio of eigenvalues: cuts that meet at an angle

glm::dvec3 unit_or_nil(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

// The length of the run for which each of its points stands.
std::vector<double> lengths_of_points(const CutRun& run)
{
    std::vector<double> out(run.last + 1, 0.0);
    for (std::size_t i = 0; i < run.last; ++i)
        for (const std::size_t k : {i, i + 1}) out[k] += (run.at[i + 1].s - run.at[i].s) / 2;
    return out;
}

// The mean directions round each point of a run, or that of all.
std::vector<glm::dvec3> smoothed_directions(const CutRun& run, bool parallel,
                                            const CutDrawing& drawing, const Inward& inward)
{
    const std::vector<double> lengths = lengths_of_points(run);
    std::vector<glm::dvec3> own, out;
    for (std::size_t i = 0; i <= run.last; ++i)
        own.push_back(unit_or_nil(inward.outward(drawing.point(run.at[i].point))));
    const auto mean = [&](const auto& weight) { // weight(k)
        glm::dvec3 sum(0);
        for (std::size_t k = 0; k <= run.last; ++k) sum += lengths[k] * weight(k) * own[k];
        return unit_or_nil(sum);
    };
    if (parallel) return std::vector(run.last + 1, mean([](std::size_t) { return 1.0; }));
    for (std::size_t i = 0; i <= run.last; ++i)
        out.push_back(mean([&](std::size_t k) {
            double away = std::abs(run.at[i].s - run.at[k].s);
            if (run.closed()) away = std::min(away, run.length - away);
            const double x = std::min(1.0, away / (smoothed_over * run.length));
            return (1 - x * x) * (1 - x * x);
        }));
    return out;
}

// What leans at a point: directions to the left of the cuts that meet there, and the tangents of
// their angles.
struct Lean {
    std::uint32_t point;
    std::vector<std::pair<glm::dvec3, double>> cuts = {};
    bool any = false;
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
        const double t = std::min(1.0, ratio / apart_enough);
        v += t * t * (3 - 2 * t) * glm::dot(second, b) / (mean - half) * second;
    }
    return v.x * x + v.y * y;
}

std::vector<Lean> leans_of(const std::vector<CutRun>& runs, const CutDrawing& drawing,
                           const Inward& inward, std::span<const Incision> incisions)
{
    std::vector<Lean> out;
    if (std::ranges::none_of(
            runs, [&](const CutRun& run) { return incisions[run.incision].lean_deg != 0; }))
        return out;
    KeyNumbers number;
    for (const CutRun& run : runs) {
        const Incision& incision = incisions[run.incision];
        const CutCurve curve(run, drawing, inward, incision.width);
        const double tangent = std::tan(incision.lean_deg * std::numbers::pi / 180);
        for (std::size_t i = 0; i <= run.last; ++i) {
            const auto [n, fresh] = number.number(run.at[i].point);
            if (fresh) out.push_back({run.at[i].point});
            out[n].cuts.emplace_back(curve.left(run.at[i].s), tangent);
            out[n].any = out[n].any || tangent != 0;
        }
    }
    return out;
}

} // namespace

CutColumns columns_of(const std::vector<CutRun>& runs, const std::vector<char>& parallel,
                      const CutDrawing& drawing, const Inward& inward,
                      std::span<const Incision> incisions)
{
    CutColumns out(drawing, inward);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (runs[k].kind != CutRun::Kind::through) continue;
        const std::vector<glm::dvec3> directions =
            smoothed_directions(runs[k], parallel[k], drawing, inward);
        for (std::size_t i = 0; i <= runs[k].last; ++i)
            out.turn(runs[k].at[i].point, directions[i]);
    }
    const CutSkin& skin = drawing.skin();
    for (const Lean& lean : leans_of(runs, drawing, inward, incisions)) {
        if (!lean.any) continue;
        const glm::dvec3 straight = out.outward(lean.point);
        const double length = glm::length(straight);
        if (!(length > 0)) continue;
        glm::dvec3 offset = length * offset_of(lean, straight / length);
        const auto seen = [&] {
            const glm::dvec3 outward = glm::normalize(straight - offset);
            return std::ranges::all_of(
                triangles_round(skin, drawing.point(lean.point)), [&](std::uint32_t t) {
                    return glm::dot(unit_or_nil(skin.area_normal(t)), outward) > seen_enough;
                });
        };
        for (int i = 0; i < most_leans && !seen(); ++i) offset *= less_leaning;
        if (seen()) out.turn(lean.point, straight - offset);
    }
    return out;
}

} // namespace trivar
