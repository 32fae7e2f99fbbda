// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/bicubic_cells.h"

#include "core/spline/bezier.h"

namespace trivar {
namespace {

// The coefficients of x^0..x^3 of a Bezier polynomial.
std::array<double, 4> powers_of_bezier(double a, double b, double c, double d)
{
    return {a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c)};
}

} // namespace

BicubicCells::BicubicCells(const Surface<double>& surface)
{
    const Surface<double> bezier = bezier_form(surface);
    const std::vector<BezierSpan> us = bezier_spans(bezier.axes[0]);
    const std::vector<BezierSpan> vs = bezier_spans(bezier.axes[1]);
    count_ = {static_cast<int>(us.size()), static_cast<int>(vs.size())};
    begin_ = {us.front().lo, vs.front().lo};
    per_cell_ = glm::dvec2(count_) / (glm::dvec2(us.back().hi, vs.back().hi) - begin_);
    for (const BezierSpan& u : us)
        for (const BezierSpan& v : vs) {
            std::array<std::array<double, 4>, 4> rows; // powers of v, by control row
            for (int i = 0; i < 4; ++i)
                rows[static_cast<std::size_t>(i)] = powers_of_bezier(
                    bezier.point(u.first + i, v.first), bezier.point(u.first + i, v.first + 1),
                    bezier.point(u.first + i, v.first + 2), bezier.point(u.first + i, v.first + 3));
            std::array<std::array<double, 4>, 4> columns; // powers of u, by power of v
            for (std::size_t j = 0; j < 4; ++j)
                columns[j] = powers_of_bezier(rows[0][j], rows[1][j], rows[2][j], rows[3][j]);
            for (const std::array<double, 4>& column : columns)
                powers_.insert(powers_.end(), column.begin(), column.end());
        }
}

} // namespace trivar
