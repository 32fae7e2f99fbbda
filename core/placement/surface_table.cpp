// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/surface_table.h"

#include "core/base/mistake.h"
#include "core/placement/contact.h"

#include <algorithm>

namespace trivar {
namespace {

using Polynomial = std::array<double, max_order>; // of x, 0 at the span's begin and 1 at its end

// Computes the basis polynomials of a span by the recursion of Cox and de Boor on polynomials.
std::array<Polynomial, max_order> span_polynomials(const std::vector<double>& t, int order, int s)
{
    const auto knot = [&](int i) { return t[static_cast<std::size_t>(i)]; };
    const double begin = knot(s), length = knot(s + 1) - knot(s);
    std::array<Polynomial, max_order> row{};
    row[0][0] = 1;
    for (int k = 2; k <= order; ++k) {
        std::array<Polynomial, max_order> next{};
        // Adds p times the line from `at_begin` at 0 that rises by `rise` to 1.
        const auto add = [&](Polynomial& to, const Polynomial& p, double at_begin, double rise) {
            for (std::size_t c = 0; c < max_order; ++c)
                to[c] += at_begin * p[c] + (c > 0 ? rise * p[c - 1] : 0.0);
        };
        for (int j = 0; j < k; ++j) {
            const int i = s - k + 1 + j;
            const auto J = static_cast<std::size_t>(j);
            if (j > 0) {
                const double support = knot(i + k - 1) - knot(i);
                add(next[J], row[J - 1], (begin - knot(i)) / support, length / support);
            }
            if (j < k - 1) {
                const double support = knot(i + k) - knot(i + 1);
                add(next[J], row[J], (knot(i + k) - begin) / support, -length / support);
            }
        }
        row = next;
    }
    return row;
}

} // namespace

AxisTable::AxisTable(const Knots& knots) : order_(knots.order()), breaks_(knots.breaks())
{
    ensure(knots.closure() == Closure::open, "an axis is closed");
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
        const int s = knots.span(breaks_[k]);
        spans_.push_back({breaks_[k], 1 / (breaks_[k + 1] - breaks_[k]), s - order_ + 1});
        const auto polynomials = span_polynomials(knots.values(), order_, s);
        for (int i = 0; i < order_; ++i)
            for (int c = 0; c < order_; ++c)
                coefficients_.push_back(
                    polynomials[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)]);
    }
    spans_a_unit_ = static_cast<double>(spans_.size()) / (breaks_.back() - breaks_.front());
}

// known_order is the order if it is known at compile time, or 0.
template <std::size_t known_order> AxisTable::Row AxisTable::row(double t) const
{
    const std::size_t order = known_order > 0 ? known_order : static_cast<std::size_t>(order_);
    const std::size_t last = spans_.size() - 1;
    // This is exact for uniform knots; for others it is a start for the search.
    const double guess = std::max(0.0, (t - breaks_.front()) * spans_a_unit_);
    std::size_t k = guess < static_cast<double>(last) ? static_cast<std::size_t>(guess) : last;
    while (k > 0 && t < breaks_[k]) --k;
    while (k < last && t >= breaks_[k + 1]) ++k;
    const Span& span = spans_[k];
    const double x = (t - span.begin) * span.one_over_length;
    const double* c = coefficients_.data() + k * order * order;
    AxisTable::Row out;
    out.first = span.first;
    for (std::size_t i = 0; i < order; ++i, c += order) {
        double value = c[order - 1], slope = 0;
        for (std::size_t p = order - 1; p > 0; --p) {
            slope = slope * x + value;
            value = value * x + c[p - 1];
        }
        out.value[i] = value;
        out.slope[i] = slope * span.one_over_length;
    }
    return out;
}

AxisTable::Row AxisTable::at(double t) const
{
    if (order_ == 3) return row<3>(t);
    if (order_ == 4) return row<4>(t);
    return row<0>(t);
}

SurfaceTable::SurfaceTable(const Surface<glm::dvec3>& surface)
    : surface_(surface),
      axes_{AxisTable(surface.axes[0]), AxisTable(surface.axes[1])},
      cells_(surface.axes[0].count() - 1, surface.axes[1].count() - 1)
{
    for (const Knots& knots : surface.axes)
        for (int i = 1; i + 1 < knots.count() && knots.order() > 2; ++i)
            creased_ = creased_ || trivar::creased(knots, i);
}

// known_rows and known_columns are the orders if they are known at compile time, or 0.
template <std::size_t known_rows, std::size_t known_columns>
SurfaceTable::Jet SurfaceTable::jet_of(glm::dvec2 uv) const
{
    const AxisTable::Row a = axes_[0].row<known_rows>(uv.x), b = axes_[1].row<known_columns>(uv.y);
    const auto rows =
        known_rows > 0 ? known_rows : static_cast<std::size_t>(surface_.axes[0].order());
    const auto columns =
        known_columns > 0 ? known_columns : static_cast<std::size_t>(surface_.axes[1].order());
    const glm::dvec3* p = &surface_.points[surface_.index(a.first, b.first)];
    const auto stride = static_cast<std::size_t>(surface_.axes[1].count());
    Jet out;
    for (std::size_t i = 0; i < rows; ++i, p += stride) {
        glm::dvec3 along(0), across(0);
        for (std::size_t j = 0; j < columns; ++j) {
            along += b.value[j] * p[j];
            across += b.slope[j] * p[j];
        }
        out.value += a.value[i] * along;
        out.u += a.slope[i] * along;
        out.v += a.value[i] * across;
    }
    return out;
}

SurfaceTable::Jet SurfaceTable::jet(glm::dvec2 uv) const
{
    const int rows = surface_.axes[0].order(), columns = surface_.axes[1].order();
    // The usual orders have loops that the compiler can unroll: half of the time of a lift is spent
    // here.
    if (rows == 3 && columns == 3) return jet_of<3, 3>(uv);
    if (rows == 4 && columns == 4) return jet_of<4, 4>(uv);
    return jet_of<0, 0>(uv);
}

std::vector<glm::dvec3> SurfaceTable::grid(std::span<const double> u,
                                           std::span<const double> v) const
{
    std::vector<AxisTable::Row> across;
    for (const double t : v) across.push_back(axes_[1].at(t));
    const int first = across.front().first, last = across.back().first + surface_.axes[1].order();
    std::vector<glm::dvec3> out, line(static_cast<std::size_t>(last - first));
    out.reserve(u.size() * v.size());
    for (const double t : u) {
        const AxisTable::Row a = axes_[0].at(t);
        std::fill(line.begin(), line.end(), glm::dvec3(0));
        for (int k = 0; k < surface_.axes[0].order(); ++k) {
            const glm::dvec3* points = &surface_.points[surface_.index(a.first + k, first)];
            for (std::size_t j = 0; j < line.size(); ++j)
                line[j] += a.value[static_cast<std::size_t>(k)] * points[j];
        }
        for (const AxisTable::Row& b : across) {
            glm::dvec3 p(0);
            for (int k = 0; k < surface_.axes[1].order(); ++k)
                p += b.value[static_cast<std::size_t>(k)] *
                     line[static_cast<std::size_t>(b.first - first + k)];
            out.push_back(p);
        }
    }
    return out;
}

std::vector<glm::dvec3> SurfaceTable::grid(glm::ivec2 steps) const
{
    std::vector<double> u, v;
    for (int i = 0; i <= steps.x; ++i) u.push_back(static_cast<double>(i) / steps.x);
    for (int j = 0; j <= steps.y; ++j) v.push_back(static_cast<double>(j) / steps.y);
    return grid(u, v);
}

std::vector<char> SurfaceTable::touched(glm::ivec2 steps, const std::vector<char>& points) const
{
    std::vector<int> across;
    for (int j = 0; j <= steps.y; ++j)
        across.push_back(axes_[1].at(static_cast<double>(j) / steps.y).first);
    std::vector<char> out;
    out.reserve(static_cast<std::size_t>(steps.x + 1) * across.size());
    for (int i = 0; i <= steps.x; ++i) {
        const int first = axes_[0].at(static_cast<double>(i) / steps.x).first;
        for (const int column : across) {
            char any = 0;
            for (int k = 0; k < surface_.axes[0].order(); ++k)
                for (int l = 0; l < surface_.axes[1].order(); ++l)
                    any = any || points[surface_.index(first + k, column + l)];
            out.push_back(any);
        }
    }
    return out;
}

} // namespace trivar
