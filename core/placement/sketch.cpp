// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sketch.h"

#include "core/base/finite.h"
#include "core/base/rejected.h"
#include "core/spline/fit.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double shortest_stroke_px = 8;
constexpr std::size_t most_points = 1000;
constexpr int most_stroke_points = 200;

void check(const Camera& c)
{
    const bool numbers = finite(c.eye) && finite(c.target) && finite(c.up) &&
                         std::isfinite(c.fov_y) && std::isfinite(c.height_world) &&
                         std::isfinite(c.size_px.x) && std::isfinite(c.size_px.y);
    const bool sizes = c.size_px.x > 0 && c.size_px.y > 0 && c.eye != c.target &&
                       (c.perspective ? c.fov_y > 0 && c.fov_y < 3.1 : c.height_world > 0);
    if (!numbers || !sizes)
        throw Rejected("the camera of the stroke is not valid: its eye and target must differ, and "
                       "its angle and picture size must be above 0");
}

double length_of(const std::vector<glm::dvec2>& points)
{
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::length(points[i] - points[i - 1]);
    return sum;
}

std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& points, std::size_t count)
{
    const double length = length_of(points);
    std::vector<glm::dvec2> out{points.front()};
    double passed = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        passed += glm::length(points[i] - points[i - 1]);
        if (passed * static_cast<double>(count) >= static_cast<double>(out.size()) * length)
            out.push_back(points[i]);
    }
    if (out.back() != points.back()) out.push_back(points.back());
    return out;
}

// Says whether the stroke returns to its beginning.
bool closes(const std::vector<glm::dvec2>& points)
{
    return glm::length(points.back() - points.front()) <= ring_closing_px &&
           length_of(points) >= 10 * ring_closing_px;
}

Knots with(const Knots& knots, const std::vector<double>& more)
{
    const bool open = knots.closure() == Closure::open;
    std::vector<double> all = open ? knots.values() : knots.breaks();
    if (!open) all.pop_back(); // the end is the beginning of the next period
    all.insert(all.end(), more.begin(), more.end());
    std::sort(all.begin(), all.end());
    return open ? Knots::general(knots.order(), std::move(all))
                : Knots::closed(knots.order(), all, knots.end());
}

// Adds a knot in the middle of every span whose error is too large.
Knots refined(const Curve<glm::dvec2>& curve, const std::vector<glm::dvec2>& points,
              const std::vector<double>& t, double tolerance_px)
{
    struct Span {
        double worst = 0;
        int low = 0, high = 0; // samples in its halves
    };
    const std::vector<double> breaks = curve.knots.breaks();
    const auto middle = [&](std::size_t b) { return (breaks[b] + breaks[b + 1]) / 2; };
    std::vector<Span> spans(breaks.size() - 1);
    for (std::size_t s = 0; s < points.size(); ++s) {
        const auto above = std::upper_bound(breaks.begin(), breaks.end() - 1, t[s]);
        const auto b = static_cast<std::size_t>(above - breaks.begin()) - 1;
        spans[b].worst =
            std::max(spans[b].worst, glm::length(evaluate(curve, t[s]).value - points[s]));
        ++(t[s] < middle(b) ? spans[b].low : spans[b].high);
    }
    std::vector<double> more;
    for (std::size_t b = 0; b < spans.size(); ++b)
        // A half without two samples of its own would swing freely (Schoenberg and Whitney).
        if (spans[b].worst > tolerance_px && spans[b].low >= 2 && spans[b].high >= 2 &&
            curve.knots.count() + static_cast<int>(more.size()) < most_stroke_points)
            more.push_back(middle(b));
    return with(curve.knots, more);
}

} // namespace

std::vector<glm::dvec2> stroke_points(const Sketch& sketch)
{
    check(sketch.camera);
    std::vector<glm::dvec2> out;
    for (const StrokeSample& sample : sketch.samples) {
        const glm::dvec2 p = sample.p_px;
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            throw Rejected("the stroke has a position that is not a number; draw it again");
        if (p.x < 0 || p.y < 0 || p.x > sketch.camera.size_px.x || p.y > sketch.camera.size_px.y)
            throw Rejected("the stroke leaves the picture; keep it inside or zoom out first");
        if (out.empty() || glm::length(p - out.back()) >= 0.5) out.push_back(p);
    }
    if (out.size() < 2) throw Rejected("that was a click; drag to draw a stroke");
    if (length_of(out) < shortest_stroke_px)
        throw Rejected("the stroke is too short; draw one of at least 8 pixels");
    return out.size() > most_points ? thinned(out, most_points) : out;
}

Curve<glm::dvec2> fit_sketch(const std::vector<glm::dvec2>& points, double tolerance_px)
{
    std::vector<glm::dvec2> p = points;
    const bool closed = closes(p);
    if (closed) p.back() = p.front();
    // Two or three points do not determine a cubic, so points between them are added.
    while (p.size() < 8) {
        std::vector<glm::dvec2> finer{p.front()};
        for (std::size_t i = 1; i < p.size(); ++i) {
            finer.push_back((p[i - 1] + p[i]) / 2.0);
            finer.push_back(p[i]);
        }
        p = std::move(finer);
    }
    std::vector<double> t = chord_length_parameters(p);
    if (closed) { // the last is the first one, a period later
        p.pop_back();
        t.pop_back();
    }
    // A trace of smoothing keeps a span whose samples crowd at one end from swinging; on samples
    // that fix every span it is below rounding.
    const FitOptions options{.smoothing = 1e-13, .ends = !closed};
    Curve<glm::dvec2> curve =
        fit(closed ? Knots::periodic(4, 4) : Knots::uniform(4, 4), t, p, options);
    for (;;) {
        t = corrected_parameters(curve, std::move(t), p);
        const Knots knots = refined(curve, p, t, tolerance_px);
        const bool settled = knots == curve.knots;
        curve = fit(knots, t, p, options);
        if (settled) return curve;
    }
}

double curvature(const CurveJet<glm::dvec2>& jet)
{
    const double speed = glm::length(jet.first);
    if (!(speed > 0)) return 0;
    // Rows of the picture go down, so a left turn has a negative cross product.
    return (jet.first.y * jet.second.x - jet.first.x * jet.second.y) / (speed * speed * speed);
}

glm::dvec2 left_normal(const CurveJet<glm::dvec2>& jet)
{
    const double speed = glm::length(jet.first);
    if (!(speed > 0)) return {0, -1};
    return glm::dvec2(jet.first.y, -jet.first.x) / speed;
}

} // namespace trivar
