// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/surface_bounds.h"

#include "core/base/parallel.h"
#include "core/spline/bezier.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace trivar {
namespace {

constexpr int net = 4; // Bezier points of a piece along either axis
using Net = std::array<double, net * net>;

// Largest |difference| of a net of the given size, after `dv` differences by v and `dw` by w.
template <int dv, int dw> double largest_difference(Net p)
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

BendBounds::Bend greatest(const BendBounds::Bend& a, const BendBounds::Bend& b)
{
    return {std::max(a.vv, b.vv), std::max(a.vw, b.vw), std::max(a.ww, b.ww)};
}

} // namespace

SurfaceBounds::SurfaceBounds(const Surface<double>& surface, bool zero_outside, int parts)
    : zero_outside_(zero_outside)
{
    const Surface<double> bezier = bezier_form(surface);
    std::array<std::vector<BezierSpan>, 2> spans;
    for (std::size_t a = 0; a < 2; ++a) spans[a] = bezier_spans(bezier.axes[a]);
    lo_ = {spans[0].front().lo, spans[1].front().lo};
    hi_ = {spans[0].back().hi, spans[1].back().hi};
    const glm::ivec2 pieces(spans[0].size(), spans[1].size());
    count_ = pieces * parts;
    per_cell_ = glm::dvec2(count_) / (hi_ - lo_);
    cells_.resize(static_cast<std::size_t>(count_.x * count_.y));
    using Rows = std::array<double, max_order * max_order>;
    std::vector<Rows> segments; // that give the control points of a part
    const double share = 1.0 / parts;
    for (int part = 0; part < parts; ++part)
        segments.push_back(bezier_segment(net, part * share, (part + 1) * share));
    const auto at = [](auto& values, int k, int l) -> auto&
    {
        return values[static_cast<std::size_t>(k * net + l)];
    };
    const auto columns = static_cast<std::size_t>(pieces.y);
    const auto bound_piece = [&](int i, int j) {
        const BezierSpan& sv = spans[0][static_cast<std::size_t>(i)];
        const BezierSpan& sw = spans[1][static_cast<std::size_t>(j)];
        Net whole;
        for (int k = 0; k < net; ++k)
            for (int l = 0; l < net; ++l)
                at(whole, k, l) = bezier.point(sv.first + k, sw.first + l);
        const double v = (net - 1) * parts / (sv.hi - sv.lo);
        const double w = (net - 1) * parts / (sw.hi - sw.lo);
        const double vv = v * (net - 2) * parts / (sv.hi - sv.lo);
        const double ww = w * (net - 2) * parts / (sw.hi - sw.lo);
        for (int a = 0; a < parts; ++a) {
            const Rows& by_v = segments[static_cast<std::size_t>(a)];
            Net half{};
            for (int k = 0; k < net; ++k)
                for (int m = 0; m < net; ++m)
                    for (int l = 0; l < net; ++l)
                        at(half, k, l) += at(by_v, k, m) * at(whole, m, l);
            for (int b = 0; b < parts; ++b) {
                const Rows& by_w = segments[static_cast<std::size_t>(b)];
                Net p{};
                for (int k = 0; k < net; ++k)
                    for (int l = 0; l < net; ++l)
                        for (int m = 0; m < net; ++m)
                            at(p, k, l) += at(by_w, l, m) * at(half, k, m);
                cells_[static_cast<std::size_t>((i * parts + a) * count_.y + j * parts + b)] = {
                    largest_difference<0, 0>(p),         v * largest_difference<1, 0>(p),
                    w * largest_difference<0, 1>(p),     vv * largest_difference<2, 0>(p),
                    v * w * largest_difference<1, 1>(p), ww * largest_difference<0, 2>(p)};
            }
        }
    };
    constexpr std::size_t pieces_per_block = 64;
    parallel_blocks(static_cast<std::size_t>(pieces.x) * columns, pieces_per_block,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t k = begin; k < end; ++k)
                            bound_piece(static_cast<int>(k / columns),
                                        static_cast<int>(k % columns));
                    });
}

BendBounds::BendBounds(std::span<const SurfaceBounds> surfaces) : grid_(surfaces[0])
{
    const glm::ivec2 count = grid_.count_;
    levels_ = {std::bit_width(static_cast<unsigned>(count.x)),
               std::bit_width(static_cast<unsigned>(count.y))};
    most_.resize(static_cast<std::size_t>(levels_.x * levels_.y * count.x * count.y));
    for (const SurfaceBounds& surface : surfaces)
        for (std::size_t k = 0; k < surface.cells_.size(); ++k) {
            const JetBound& cell = surface.cells_[k];
            most_[k] = greatest(most_[k], {cell.vv, cell.vw, cell.ww});
        }
    std::size_t k = surfaces[0].cells_.size();
    for (int p = 0; p < levels_.x; ++p)
        for (int q = p == 0 ? 1 : 0; q < levels_.y; ++q)
            for (int i = 0; i < count.x; ++i)
                for (int j = 0; j < count.y; ++j, ++k) {
                    // The bound combines both halves; cells beyond the grid are never queried.
                    const int next_i = std::min(count.x - 1, q > 0 ? i : i + (1 << p >> 1));
                    const int next_j = std::min(count.y - 1, q > 0 ? j + (1 << q >> 1) : j);
                    const int from_p = q > 0 ? p : p - 1, from_q = q > 0 ? q - 1 : 0;
                    most_[k] =
                        greatest(most(from_p, from_q, i, j), most(from_p, from_q, next_i, next_j));
                }
    grid_.cells_.clear();
}

BendBounds::Bend BendBounds::over(const glm::dvec2& lo, const glm::dvec2& hi) const
{
    if (grid_.is_outside(lo, hi)) return {};
    const SurfaceBounds::Cells cells = grid_.cells(lo, hi);
    const int p = std::bit_width(static_cast<unsigned>(cells.to_v - cells.from_v + 1)) - 1;
    const int q = std::bit_width(static_cast<unsigned>(cells.to_w - cells.from_w + 1)) - 1;
    const int last_v = cells.to_v + 1 - (1 << p), last_w = cells.to_w + 1 - (1 << q);
    return greatest(
        greatest(most(p, q, cells.from_v, cells.from_w), most(p, q, last_v, cells.from_w)),
        greatest(most(p, q, cells.from_v, last_w), most(p, q, last_v, last_w)));
}

} // namespace trivar
