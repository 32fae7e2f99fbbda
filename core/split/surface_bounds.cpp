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

SurfaceBounds::SurfaceBounds(const Surface<double>& surface, bool zero_outside)
    : zero_outside_(zero_outside)
{
    const Surface<double> bezier = bezier_form(surface);
    std::array<std::vector<BezierSpan>, 2> spans;
    for (std::size_t a = 0; a < 2; ++a) spans[a] = bezier_spans(bezier.axes[a]);
    lo_ = {spans[0].front().lo, spans[1].front().lo};
    hi_ = {spans[0].back().hi, spans[1].back().hi};
    count_ = {static_cast<int>(spans[0].size()), static_cast<int>(spans[1].size())};
    per_cell_ = glm::dvec2(count_) / (hi_ - lo_);
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
    if (zero_outside_ && (hi.x <= lo_.x || hi.y <= lo_.y || lo.x >= hi_.x || lo.y >= hi_.y))
        return {};
    // At a border between pieces, where rounding decides, both count
    constexpr double rounding = 1e-9;
    const glm::dvec2 last(count_ - 1);
    const glm::ivec2 from(glm::clamp((lo - lo_) * per_cell_ - rounding, glm::dvec2(0), last));
    const glm::ivec2 to(glm::clamp((hi - lo_) * per_cell_ + rounding, glm::dvec2(0), last));
    JetBound out;
    for (int i = from.x; i <= to.x; ++i)
        for (int j = from.y; j <= to.y; ++j)
            out.add(cells_[static_cast<std::size_t>(i * count_.y + j)]);
    return out;
}

} // namespace trivar
