// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/profile.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/spline/curve.h"
#include "core/spline/fit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr int brush_points = 9;
constexpr std::size_t brush_steps = 129;
constexpr double thinnest_stroke = 0.1,
                 thickest_stroke = 2; // what a brush gives, relative to the width
constexpr double slowness = 0.5;      // the width grows with this power of the slowness
constexpr double hand_s = 0.08;       // a hand's speed is its mean over this time

// Interpolates values given at ascending places linearly.
double interpolated(const std::vector<double>& places, const std::vector<double>& values, double at)
{
    const auto above = std::upper_bound(places.begin(), places.end(), at);
    if (above == places.begin()) return values.front();
    if (above == places.end()) return values.back();
    const auto i = static_cast<std::size_t>(above - places.begin());
    const double f = (at - places[i - 1]) / (places[i] - places[i - 1]);
    return values[i - 1] * (1 - f) + values[i] * f;
}

std::vector<double> walked_px(const std::vector<StrokeSample>& samples)
{
    std::vector<double> out(samples.size(), 0);
    for (std::size_t i = 1; i < samples.size(); ++i)
        out[i] = out[i - 1] + glm::distance(samples[i].p_px, samples[i - 1].p_px);
    return out;
}

// Returns the speed at each sample, pixels per second; 0 if the clock stood still.
std::vector<double> speeds(const std::vector<StrokeSample>& samples,
                           const std::vector<double>& walked)
{
    std::vector<double> out(samples.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::size_t from = i, to = i;
        while (from > 0 && samples[i].time_s - samples[from].time_s < hand_s / 2) --from;
        while (to + 1 < samples.size() && samples[to].time_s - samples[i].time_s < hand_s / 2) ++to;
        const double time = samples[to].time_s - samples[from].time_s;
        out[i] = time > 0 ? (walked[to] - walked[from]) / time : 0;
    }
    return out;
}

std::vector<double> brush_factors(const std::vector<StrokeSample>& samples,
                                  const std::vector<double>& walked, Brush brush)
{
    std::vector<double> out;
    if (brush == Brush::pressure)
        for (const StrokeSample& sample : samples) out.push_back(2 * sample.pressure);
    if (brush == Brush::speed) {
        out = speeds(samples, walked);
        std::vector<double> sorted = out;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        const double usual = *middle;
        for (double& v : out)
            v = usual > 0 && v > 0 ? std::pow(usual / v, slowness)
                : usual > 0        ? thickest_stroke
                                   : 1;
    }
    for (double& v : out) v = std::clamp(v, thinnest_stroke, thickest_stroke);
    return out;
}

} // namespace

ShareCurve::ShareCurve(const std::vector<glm::dvec2>& points)
{
    if (points.empty()) return;
    const int count = static_cast<int>(points.size());
    const Curve<glm::dvec2> curve{Knots::uniform(std::min(3, count), count), points};
    const std::vector<double> breaks = curve.knots.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const glm::dvec2 a = i == 0 ? points.front() : pieces_.back().c;
        const glm::dvec2 c =
            i + 2 == breaks.size() ? points.back() : evaluate(curve, breaks[i + 1]).value;
        const glm::dvec2 middle = evaluate(curve, (breaks[i] + breaks[i + 1]) / 2).value;
        pieces_.push_back({a, 2.0 * middle - (a + c) / 2.0, c});
    }
}

double ShareCurve::at(double share) const
{
    share = std::clamp(share, 0.0, 1.0);
    auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), share,
                                  [](double s, const Piece& p) { return s < p.a.x; });
    if (piece != pieces_.begin()) --piece;
    // a (1 - x)^2 + 2 b x (1 - x) + c x^2 = share; the slope b - a is not negative, so this root is
    // the one in [0, 1] and loses no digits.
    const double square = piece->a.x - 2 * piece->b.x + piece->c.x;
    const double slope = 2 * (piece->b.x - piece->a.x), rest = piece->a.x - share;
    const double below = slope + std::sqrt(std::max(0.0, slope * slope - 4 * square * rest));
    const double x = below > 0 ? std::clamp(-2 * rest / below, 0.0, 1.0) : 0;
    return piece->a.y * (1 - x) * (1 - x) + 2 * piece->b.y * x * (1 - x) + piece->c.y * x * x;
}

Profile::Profile(const std::vector<glm::dvec2>& points)
{
    if (points.empty()) return;
    check_profile(points, "the profile");
    even_ = largest_ = points.front().y;
    bool same = true;
    for (const glm::dvec2& p : points) {
        largest_ = std::max(largest_, p.y);
        same = same && p.y == even_;
    }
    if (!same) curve_ = ShareCurve(points);
}

Rise::Rise(const std::vector<glm::dvec2>& points, Knots above)
    : above_(std::move(above)),
      itself_(std::ranges::all_of(points, [](const glm::dvec2& p) { return p.y == p.x; }))
{
    check_rise(points, "the rise");
    const ShareCurve curve(points);
    for (int k = 0; k < above_.count(); ++k)
        points_.push_back(itself_ ? above_.greville(k) : curve.at(above_.greville(k)));
}

double Rise::at(double w) const
{
    if (itself_) return w;
    const Basis b = basis(above_, std::clamp(w, 0.0, 1.0));
    double sum = 0;
    for (int k = 0; k < above_.order(); ++k)
        sum += b.value[static_cast<std::size_t>(k)] * point(b.first + k);
    return sum;
}

double Rise::w_at(double risen) const
{
    if (itself_) return std::clamp(risen, 0.0, 1.0);
    double lo = 0, hi = 1;
    for (int i = 0; i < 50; ++i) {
        const double middle = (lo + hi) / 2;
        (at(middle) < risen ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

namespace {

// Throws Rejected if there are too few or too many points, or if they do not ascend from 0 to 1.
void check_places(const std::vector<glm::dvec2>& points, const std::string& name)
{
    if (points.size() == 1) throw Rejected(name + " has one point but needs two or none");
    if (points.size() > most_profile_points)
        throw Rejected(fmt::format("{} has {} points but at most {} are allowed", name,
                                   points.size(), most_profile_points));
    if (points.front().x != 0 || points.back().x != 1)
        throw Rejected(name + " must begin at 0 and end at 1");
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i].x > points[i - 1].x))
            throw Rejected(name + " must have its points in ascending order");
}

} // namespace

void check_profile(const std::vector<glm::dvec2>& points, const std::string& name)
{
    if (points.empty()) return;
    check_places(points, name);
    for (const glm::dvec2& p : points)
        if (!(p.y >= least_profile && p.y <= most_profile))
            throw Rejected(fmt::format("{} has the factor {}, but factors must be from {} to {}",
                                       name, number_text(p.y, {.digits = 6}),
                                       number_text(least_profile), number_text(most_profile)));
}

void check_rise(const std::vector<glm::dvec2>& points, const std::string& name)
{
    if (points.empty()) return;
    check_places(points, name);
    if (points.front().y != 0 || points.back().y != 1)
        throw Rejected(name + " must rise from 0 at the bottom to 1 at the top");
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i].y - points[i - 1].y >= least_rise))
            throw Rejected(fmt::format("{} goes from {} to {} at its point {}, but must "
                                       "rise by at least {} from point to point, or the volume "
                                       "would fold",
                                       name, number_text(points[i - 1].y, {.digits = 6}),
                                       number_text(points[i].y, {.digits = 6}), i + 1,
                                       number_text(least_rise)));
}

std::vector<glm::dvec2> brush_profile(const std::vector<StrokeSample>& samples, Brush brush)
{
    if (brush == Brush::even || samples.size() < 2) return {};
    std::vector<double> walked = walked_px(samples);
    const double length = walked.back();
    if (!(length > 0)) return {};
    const std::vector<double> factors = brush_factors(samples, walked, brush);
    for (double& w : walked) w /= length;
    std::vector<double> shares;
    std::vector<glm::dvec2> wanted;
    for (std::size_t i = 0; i < brush_steps; ++i) {
        shares.push_back(static_cast<double>(i) / static_cast<double>(brush_steps - 1));
        wanted.emplace_back(shares.back(), interpolated(walked, factors, shares.back()));
    }
    const Knots knots = Knots::uniform(3, brush_points);
    std::vector<glm::dvec2> out = fit(knots, shares, wanted, {.smoothing = 1e-6}).points;
    double least = thickest_stroke, most = thinnest_stroke;
    for (int i = 0; i < brush_points; ++i) {
        glm::dvec2& p = out[static_cast<std::size_t>(i)];
        p = {knots.greville(i), std::clamp(p.y, thinnest_stroke, thickest_stroke)};
        least = std::min(least, p.y);
        most = std::max(most, p.y);
    }
    if (most - least < 0.02 * most) return {};
    return out;
}

} // namespace trivar
