// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip.h"

#include "core/placement/sketch.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// The inner rim keeps a tenth of the radius of the bend, so that rulings do not meet.
constexpr double share_of_turn = 0.9;
// The rim may approach the middle by at most half a pixel per pixel: a steeper notch would show.
constexpr double steepest_rim = 0.5;

// Returns the largest profile below `limit` that changes by at most steepest_rim per pixel of the
// curve. A closed curve is passed twice, because a limit on one side of the seam acts on the other.
std::vector<double> lower_envelope(std::vector<double> limit, const std::vector<double>& step_px,
                                   bool closed)
{
    for (int lap = 0; lap < (closed ? 2 : 1); ++lap) {
        if (closed) limit.front() = limit.back() = std::min(limit.front(), limit.back());
        for (std::size_t i = 1; i < limit.size(); ++i)
            limit[i] = std::min(limit[i], limit[i - 1] + steepest_rim * step_px[i]);
        for (std::size_t i = limit.size() - 1; i > 0; --i)
            limit[i - 1] = std::min(limit[i - 1], limit[i] + steepest_rim * step_px[i]);
    }
    if (closed) limit.front() = limit.back() = std::min(limit.front(), limit.back());
    return limit;
}

} // namespace

double profile_at(const std::vector<double>& profile, double t)
{
    const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(profile.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(x), profile.size() - 2);
    const double f = x - static_cast<double>(i);
    return profile[i] * (1 - f) + profile[i + 1] * f;
}

Strip::Ruling Strip::ruling(double a) const
{
    const CurveJet<glm::dvec2> jet = evaluate(center, a, 1);
    const glm::dvec2 n = left_normal(jet);
    return {jet.value - profile_at(right_px, a) * n, jet.value + profile_at(left_px, a) * n};
}

Strip strip_round(Curve<glm::dvec2> center, const std::vector<double>& half_width_px)
{
    const std::size_t n = half_width_px.size();
    std::vector<double> left = half_width_px, right = half_width_px, step_px(n, 0);
    glm::dvec2 before{0};
    CurveJet<glm::dvec2> jet;
    for (std::size_t i = 0; i < n; ++i) {
        // A corner turns within less than a step, so that the curve is also examined between steps.
        for (const double between : {-0.5, -0.25, 0.25, 0.5, 0.0}) {
            const double a = (static_cast<double>(i) + between) / static_cast<double>(n - 1);
            jet = evaluate(center, std::clamp(a, 0.0, 1.0), 2);
            const double k = curvature(jet);
            if (k == 0) continue;
            double& inner = k > 0 ? left[i] : right[i];
            inner = std::min(inner, share_of_turn / std::abs(k));
        }
        if (i > 0) step_px[i] = glm::length(jet.value - before);
        before = jet.value;
    }
    Strip out{std::move(center), left, right, std::vector<char>(n, 0)};
    for (std::size_t i = 0; i < n; ++i)
        out.narrowed[i] = left[i] < half_width_px[i] || right[i] < half_width_px[i];
    const bool closed = out.center.knots.closure() != Closure::open;
    out.left_px = lower_envelope(std::move(left), step_px, closed);
    out.right_px = lower_envelope(std::move(right), step_px, closed);
    return out;
}

double sharpest_turn(const Curve<glm::dvec2>& center, const std::vector<double>& half_width_px)
{
    // A corner turns within less than a step of the widths.
    const std::size_t count = 8 * half_width_px.size();
    std::vector<double> walked_px(count), turned(count);
    CurveJet<glm::dvec2> before = evaluate(center, 0, 1);
    double largest = 0;
    for (std::size_t i = 1, first = 0; i < count; ++i) {
        const double a = static_cast<double>(i) / static_cast<double>(count - 1);
        const CurveJet<glm::dvec2> here = evaluate(center, a, 1);
        const glm::dvec2 &from = before.first, &to = here.first;
        walked_px[i] = walked_px[i - 1] + glm::length(here.value - before.value);
        turned[i] = turned[i - 1] + std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
        const double width_px = 2 * profile_at(half_width_px, a);
        while (walked_px[i] - walked_px[first] > width_px) ++first;
        largest = std::max(largest, std::abs(turned[i] - turned[first]));
        before = here;
    }
    return largest;
}

} // namespace trivar
