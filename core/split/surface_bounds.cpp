// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/surface_bounds.h"

#include "core/spline/bezier.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int net = 4; // Bezier points of a piece along either axis

// Largest |difference| of a net of the given size, after `dv` differences by v and `dw` by w.
double largest_difference(std::array<double, net * net> p, int dv, int dw)
{
    int rows = net, columns = net;
    for (int k = 0; k < dv; ++k, --rows)
        for (int i = 0; i + 1 < rows; ++i)
            for (int j = 0; j < columns; ++j)
                p[static_cast<std::size_t>(i * net + j)] =
                    p[static_cast<std::size_t>((i + 1) * net + j)] -
                    p[static_cast<std::size_t>(i * net + j)];
    for (int k = 0; k < dw; ++k, --columns)
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j + 1 < columns; ++j)
                p[static_cast<std::size_t>(i * net + j)] =
                    p[static_cast<std::size_t>(i * net + j + 1)] -
                    p[static_cast<std::size_t>(i * net + j)];
    double most = 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            most = std::max(most, std::abs(p[static_cast<std::size_t>(i * net + j)]));
    return most;
}

} // namespace

void JetBound::add(const JetBound& other)
{
    value = std::max(value, other.value);
    v = std::max(v, other.v);
    w = std::max(w, other.w);
    vv = std::max(vv, other.vv);
    vw = std::max(vw, other.vw);
    ww = std::max(ww, other.ww);
}

double JetBound::first(const glm::dvec2& e) const
{
    return v * std::abs(e.x) + w * std::abs(e.y);
}

double JetBound::second(const glm::dvec2& e) const
{
    return vv * e.x * e.x + 2 * vw * std::abs(e.x * e.y) + ww * e.y * e.y;
}

SurfaceBounds::SurfaceBounds(const Surface<double>& surface, bool zero_outside)
    : zero_outside_(zero_outside)
{
    const Surface<double> bezier = bezier_form(surface);
    std::array<std::vector<BezierSpan>, 2> spans;
    for (std::size_t a = 0; a < 2; ++a) {
        spans[a] = bezier_spans(bezier.axes[a]);
        for (const BezierSpan& span : spans[a]) breaks_[a].push_back(span.lo);
        breaks_[a].push_back(spans[a].back().hi);
    }
    for (const BezierSpan& sv : spans[0])
        for (const BezierSpan& sw : spans[1]) {
            std::array<double, net * net> points{};
            for (int i = 0; i < net; ++i)
                for (int j = 0; j < net; ++j)
                    points[static_cast<std::size_t>(i * net + j)] =
                        bezier.point(sv.first + i, sw.first + j);
            const double v = (net - 1) / (sv.hi - sv.lo), w = (net - 1) / (sw.hi - sw.lo);
            const double vv = v * (net - 2) / (sv.hi - sv.lo), ww = w * (net - 2) / (sw.hi - sw.lo);
            cells_.push_back(
                {largest_difference(points, 0, 0), v * largest_difference(points, 1, 0),
                 w * largest_difference(points, 0, 1), vv * largest_difference(points, 2, 0),
                 v * w * largest_difference(points, 1, 1), ww * largest_difference(points, 0, 2)});
        }
}

JetBound SurfaceBounds::over(const glm::dvec2& lo, const glm::dvec2& hi) const
{
    std::array<std::size_t, 2> from{}, to{};
    for (std::size_t a = 0; a < 2; ++a) {
        const std::vector<double>& breaks = breaks_[a];
        const int axis = static_cast<int>(a);
        if (zero_outside_ && (hi[axis] <= breaks.front() || lo[axis] >= breaks.back())) return {};
        const auto piece = [&](double x) {
            const auto above = std::ranges::upper_bound(breaks, x) - breaks.begin();
            return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
                above - 1, 0, static_cast<std::ptrdiff_t>(breaks.size()) - 2));
        };
        from[a] = piece(lo[axis]);
        to[a] = piece(hi[axis]);
    }
    JetBound out;
    const std::size_t row = breaks_[1].size() - 1;
    for (std::size_t i = from[0]; i <= to[0]; ++i)
        for (std::size_t j = from[1]; j <= to[1]; ++j) out.add(cells_[i * row + j]);
    return out;
}

} // namespace trivar
