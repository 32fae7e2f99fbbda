// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/axis_cells.h"

#include "core/base/index.h"
#include "core/ffd/lattice.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Polynomial = std::array<double, max_order>;

// Returns (a + b t) p.
Polynomial times(const Polynomial& p, double a, double b)
{
    Polynomial out{};
    for (std::size_t m = 0; m < p.size(); ++m) out[m] = a * p[m] + (m > 0 ? b * p[m - 1] : 0);
    return out;
}

Polynomial plus(Polynomial p, const Polynomial& q)
{
    for (std::size_t m = 0; m < p.size(); ++m) p[m] += q[m];
    return p;
}

// Computes the basis functions of span s as polynomials in t, where u = center + width t, by the
// Cox-de Boor triangle.
std::array<Polynomial, max_order> basis_polynomials(const Knots& knots, int s, double center,
                                                    double width)
{
    const std::vector<double>& k = knots.values();
    std::array<Polynomial, max_order> n{};
    n[0][0] = 1;
    for (int p = 1; p < knots.order(); ++p) {
        Polynomial saved{};
        for (int r = 0; r < p; ++r) {
            const double lo = k[at(s + 1 - p + r)], hi = k[at(s + r + 1)];
            const Polynomial& lower = n[at(r)];
            const Polynomial falling = times(lower, (hi - center) / (hi - lo), -width / (hi - lo));
            const Polynomial rising = times(lower, (center - lo) / (hi - lo), width / (hi - lo));
            n[at(r)] = plus(saved, falling);
            saved = rising;
        }
        n[at(p)] = saved;
    }
    return n;
}

AxisCells::Cell span_cell(const Knots& knots, double begin, double end)
{
    AxisCells::Cell cell;
    const int s = knots.span(begin);
    cell.first = s - knots.order() + 1;
    cell.center = begin + (end - begin) / 2;
    cell.per_unit = 1 / (end - begin);
    const auto n = basis_polynomials(knots, s, cell.center, end - begin);
    for (std::size_t m = 0; m < n.size(); ++m)
        for (std::size_t r = 0; r < n.size(); ++r) cell.power[m][r] = n[r][m];
    return cell;
}

// Makes the cell beyond an end of the domain: constant, with the value at the end.
AxisCells::Cell end_cell(const Knots& knots, double end)
{
    const Basis b = basis(knots, end);
    AxisCells::Cell cell;
    cell.first = b.first;
    cell.center = end;
    cell.power[0] = b.value;
    return cell;
}

} // namespace

AxisCells::AxisCells(const Knots& knots)
    : breaks_(knots.breaks()),
      spans_per_unit_(static_cast<double>(breaks_.size() - 1) / (knots.end() - knots.begin())),
      least_(reach(knots).least),
      most_(reach(knots).most)
{
    cells_.reserve(breaks_.size() + 1);
    cells_.push_back(end_cell(knots, knots.begin()));
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i)
        cells_.push_back(span_cell(knots, breaks_[i], breaks_[i + 1]));
    cells_.push_back(end_cell(knots, knots.end()));
}

AxisCells::Place AxisCells::place(double u) const
{
    if (u < least_) return {0, 0.0f};
    if (u > most_) return {count() - 1, 0.0f};
    // Equally spaced knots, the usual case, are found without a search.
    const auto last = static_cast<double>(breaks_.size() - 2);
    const double guess = std::clamp((u - breaks_.front()) * spans_per_unit_, 0.0, last);
    std::size_t span = guess >= 0 ? static_cast<std::size_t>(guess) : 0; // false if u is a NaN
    if (!(breaks_[span] <= u && u < breaks_[span + 1])) {
        const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, u);
        span = static_cast<std::size_t>(above - breaks_.begin()) - 1;
    }
    const Cell& cell = cells_[span + 1];
    const double t = (u - cell.center) * cell.per_unit;
    return {static_cast<std::uint32_t>(span + 1), static_cast<float>(std::clamp(t, -0.5, 0.5))};
}

} // namespace trivar
