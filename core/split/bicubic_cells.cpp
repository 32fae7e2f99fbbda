// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/bicubic_cells.h"

#include "core/spline/bezier.h"

#include <algorithm>

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
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j) powers_.push_back(columns[j][i]);
        }
}

BicubicCells::Local BicubicCells::local(const glm::dvec2& uv) const
{
    const glm::dvec2 at = glm::clamp((uv - begin_) * per_cell_, glm::dvec2(0), glm::dvec2(count_));
    const glm::ivec2 cell = glm::min(glm::ivec2(at), count_ - 1);
    return {powers_.data() + 16 * static_cast<std::size_t>(cell.x * count_.y + cell.y),
            at.x - cell.x, at.y - cell.y};
}

double BicubicCells::value(const glm::dvec2& uv) const
{
    const auto [c, x, y] = local(uv);
    const auto row = [c = c, y = y](int i) {
        const double* const p = c + 4 * i;
        return p[0] + y * (p[1] + y * (p[2] + y * p[3]));
    };
    return row(0) + x * (row(1) + x * (row(2) + x * row(3)));
}

BicubicCells::Jet BicubicCells::jet(const glm::dvec2& uv) const
{
    const auto [c, x, y] = local(uv);
    std::array<double, 4> value{}, slope{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double* const p = c + 4 * i;
        value[i] = p[0] + y * (p[1] + y * (p[2] + y * p[3]));
        slope[i] = p[1] + y * (2 * p[2] + y * 3 * p[3]);
    }
    return {value[0] + x * (value[1] + x * (value[2] + x * value[3])),
            per_cell_.x * (value[1] + x * (2 * value[2] + x * 3 * value[3])),
            per_cell_.y * (slope[0] + x * (slope[1] + x * (slope[2] + x * slope[3])))};
}

} // namespace trivar
