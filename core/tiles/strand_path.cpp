// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand_path.h"

#include "core/base/unit.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// The most points of a path.
constexpr std::size_t most_path_points = 4'000'000;

StrandPoint between(const StrandPoint& a, const StrandPoint& b, double share)
{
    return {{glm::mix(a.at.p, b.at.p, share), glm::mix(a.at.normal, b.at.normal, share)},
            glm::mix(a.time_s, b.time_s, share),
            glm::mix(a.pressure, b.pressure, share)};
}

// The points without those that are no way from the one before.
std::vector<StrandPoint> distinct_points(const std::vector<StrandPoint>& points, bool closed,
                                         double least)
{
    std::vector<StrandPoint> out;
    for (const StrandPoint& each : points)
        if (out.empty() || glm::distance(out.back().at.p, each.at.p) > least) out.push_back(each);
    while (closed && out.size() > 1 && glm::distance(out.back().at.p, out.front().at.p) <= least)
        out.pop_back();
    return out;
}

// A point of the centripetal Catmull-Rom curve through four points, between the middle two
// (Barry and Goldman 1988; Yuksel, Schaefer, Keyser 2011).
glm::dvec3 through(const std::array<glm::dvec3, 4>& p, double share)
{
    std::array<double, 4> t{};
    for (std::size_t i = 1; i < 4; ++i)
        t[i] = t[i - 1] + std::max(1e-12, std::sqrt(glm::distance(p[i], p[i - 1])));
    const double at = glm::mix(t[1], t[2], share);
    std::array<glm::dvec3, 4> q = p;
    const auto line = [&](std::size_t i, std::size_t j, std::size_t from, std::size_t to) {
        return glm::mix(q[i], q[j], (at - t[from]) / (t[to] - t[from]));
    };
    q = {line(0, 1, 0, 1), line(1, 2, 1, 2), line(2, 3, 2, 3), {}};
    q = {line(0, 1, 0, 2), line(1, 2, 1, 3), {}, {}};
    return line(0, 1, 1, 2);
}

// The curve through all points, of which a closed one comes back to the first.
std::vector<StrandPoint> curve_through(const std::vector<StrandPoint>& points, bool closed,
                                       double step)
{
    const std::size_t n = points.size(), pieces = closed ? n : n - 1;
    const auto at = [&](std::ptrdiff_t i) {
        const auto count = static_cast<std::ptrdiff_t>(n);
        if (closed) return points[static_cast<std::size_t>((i + count) % count)].at.p;
        if (i < 0) return 2.0 * points[0].at.p - points[1].at.p;
        if (i >= count) return 2.0 * points[n - 1].at.p - points[n - 2].at.p;
        return points[static_cast<std::size_t>(i)].at.p;
    };
    std::vector<StrandPoint> out{points.front()};
    for (std::size_t k = 0; k < pieces; ++k) {
        const StrandPoint& a = points[k];
        StrandPoint b = points[(k + 1) % n];
        if (k + 1 == n) b.time_s = a.time_s; // it closes at once
        const double count = std::ceil(glm::distance(a.at.p, b.at.p) / step);
        if (!(count + static_cast<double>(out.size()) < most_path_points)) return {};
        const auto i = static_cast<std::ptrdiff_t>(k);
        const std::array<glm::dvec3, 4> p{at(i - 1), at(i), at(i + 1), at(i + 2)};
        for (double j = 1; j <= count; ++j) {
            StrandPoint& next = out.emplace_back(between(a, b, j / count));
            if (j < count) next.at.p = through(p, j / count);
        }
    }
    return out;
}

std::vector<double> lengths_of(const std::vector<StrandPoint>& points)
{
    std::vector<double> out;
    for (std::size_t i = 0; i < points.size(); ++i)
        out.push_back(i == 0 ? 0 : out.back() + glm::distance(points[i].at.p, points[i - 1].at.p));
    return out;
}

// Points at equal steps along a chain; a closed one keeps its first point at both ends.
std::vector<StrandPoint> even_points(StrandPath path, double step)
{
    const double count = std::max(1.0, std::ceil(path.length() / step));
    path.closed = false; // its end counts as its last point
    std::vector<StrandPoint> out;
    for (double i = 0; i <= count; ++i) out.push_back(path.at(path.length() * i / count));
    return out;
}

// Smooths evenly spaced points by a bell curve. Beyond an end the path goes on as its mirror image
// through the end, which so stays where it is.
std::vector<StrandPoint> smoothed(const std::vector<StrandPoint>& points, bool closed,
                                  double deviation)
{
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * deviation)),
               last = static_cast<std::ptrdiff_t>(points.size()) - 1;
    if (reach < 1 || last < 2) return points;
    const auto point = [&](std::ptrdiff_t i) { return points[static_cast<std::size_t>(i)].at; };
    const auto at = [&](std::ptrdiff_t i) -> SurfacePoint {
        if (closed) return point(((i % last) + last) % last);
        const std::ptrdiff_t end = i < 0 ? 0 : last;
        if (i >= 0 && i <= last) return point(i);
        const SurfacePoint mirror = point(std::clamp<std::ptrdiff_t>(2 * end - i, 0, last));
        return {2.0 * point(end).p - mirror.p, 2.0 * point(end).normal - mirror.normal};
    };
    std::vector<double> weights;
    for (std::ptrdiff_t k = 0; k <= reach; ++k) {
        const double x = static_cast<double>(k) / deviation;
        weights.push_back(std::exp(-x * x / 2));
    }
    std::vector<StrandPoint> out = points;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        SurfacePoint sum{glm::dvec3(0), glm::dvec3(0)};
        double all = 0;
        for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
            const double weight = weights[static_cast<std::size_t>(std::abs(k))];
            const SurfacePoint other = at(i + k);
            sum.p += weight * other.p;
            sum.normal += weight * other.normal;
            all += weight;
        }
        out[static_cast<std::size_t>(i)].at = {sum.p / all, unit_or(sum.normal, {0, 0, 1})};
    }
    return out;
}

} // namespace

StrandPoint StrandPath::at(double length) const
{
    if (points.size() < 2) return points.empty() ? StrandPoint{} : points.front();
    const double all = lengths.back();
    if (closed && all > 0) length -= all * std::floor(length / all);
    const auto found = std::ranges::upper_bound(lengths, length);
    const std::size_t b = std::clamp<std::size_t>(static_cast<std::size_t>(found - lengths.begin()),
                                                  1, points.size() - 1);
    const double way = lengths[b] - lengths[b - 1];
    return between(points[b - 1], points[b], way > 0 ? (length - lengths[b - 1]) / way : 0);
}

StrandPath strand_path(const TileBase& base, const std::vector<StrandPoint>& points, bool closed,
                       double step, double smoothing)
{
    StrandPath path{distinct_points(points, closed, 1e-3 * step), {}, closed};
    if (path.points.size() < (closed ? 3u : 2u)) return {};
    double gap = 0; // the widest between two samples
    for (std::size_t i = 1; i < path.points.size(); ++i)
        gap = std::max(gap, glm::distance(path.points[i].at.p, path.points[i - 1].at.p));
    path.points = curve_through(path.points, closed, step);
    if (path.points.size() < 2) return {};
    path.lengths = lengths_of(path.points);
    std::vector<StrandPoint> even = even_points(path, step);
    const double spacing = path.length() / static_cast<double>(even.size() - 1);
    if (!(spacing > 0)) return {};
    even = smoothed(even, closed, smoothing / spacing);
    std::vector<SurfacePoint> above;
    for (const StrandPoint& each : even) above.push_back(each.at);
    const auto places = base.locate(above, std::max(gap, 12 * step));
    path.points.clear();
    for (std::size_t i = 0; i < even.size(); ++i)
        if (places[i])
            path.points.push_back({{base.position(*places[i]), base.normal(*places[i])},
                                   even[i].time_s,
                                   even[i].pressure});
    if (path.points.size() < 2) return {};
    if (closed && even.size() > 1 && places.front() && !places.back())
        path.points.push_back(path.points.front());
    path.lengths = lengths_of(path.points);
    return path;
}

} // namespace trivar
