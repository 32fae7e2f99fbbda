// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/greville_grid.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <algorithm>

namespace trivar {

GrevilleGrid::Axis::Axis(const Knots& knots)
    : order(knots.order()),
      count(knots.count()),
      band(static_cast<std::size_t>(count * (2 * order - 1)), 0)
{
    ensure(knots.closure() == Closure::open, "an axis is closed");
    basis.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        basis.push_back(trivar::basis(knots, knots.into_domain(knots.greville(i)).t, 2));
        for (int k = 0; k < order; ++k)
            at(i, basis.back().first + k) = basis.back().value[static_cast<std::size_t>(k)];
    }
    for (int i = 0; i < count; ++i) {
        if (!(at(i, i) > 1e-9))
            throw Rejected(
                "this axis cannot be interpolated: two of its Greville abscissae coincide");
        for (int r = i + 1; r < std::min(i + order, count); ++r) {
            const double factor = at(r, i) /= at(i, i);
            for (int c = i + 1; c < std::min(i + order, count); ++c) at(r, c) -= factor * at(i, c);
        }
    }
}

double& GrevilleGrid::Axis::at(int row, int column)
{
    return band[static_cast<std::size_t>(row * (2 * order - 1) + column - row + order - 1)];
}

double GrevilleGrid::Axis::at(int row, int column) const
{
    return band[static_cast<std::size_t>(row * (2 * order - 1) + column - row + order - 1)];
}

GrevilleGrid::GrevilleGrid(std::array<Knots, 2> axes)
    : axes_(std::move(axes)),
      tables_{Axis(axes_[0]), Axis(axes_[1])}
{
}

Surface<glm::dvec3> GrevilleGrid::through(std::vector<glm::dvec3> values) const
{
    ensure(values.size() == static_cast<std::size_t>(tables_[0].count) *
                                static_cast<std::size_t>(tables_[1].count),
           "values are not of this grid");
    // Row r has `width` consecutive values; rows are `step` apart.
    const auto solve = [&](const Axis& axis, glm::dvec3* rows, int step, int width) {
        const auto subtract = [&](int from, int row, double factor) {
            glm::dvec3 *to = rows + row * step, *other = rows + from * step;
            for (int k = 0; k < width; ++k) to[k] -= factor * other[k];
        };
        for (int r = 1; r < axis.count; ++r)
            for (int c = std::max(0, r - axis.order + 1); c < r; ++c) subtract(c, r, axis.at(r, c));
        for (int r = axis.count; r-- > 0;) {
            for (int c = r + 1; c < std::min(r + axis.order, axis.count); ++c)
                subtract(c, r, axis.at(r, c));
            const double factor = 1 / axis.at(r, r);
            for (int k = 0; k < width; ++k) rows[r * step + k] *= factor;
        }
    };
    const int columns = tables_[1].count;
    solve(tables_[0], values.data(), columns, columns);
    for (int i = 0; i < tables_[0].count; ++i) solve(tables_[1], values.data() + i * columns, 1, 1);
    return {axes_, std::move(values)};
}

std::vector<SurfaceJet<glm::dvec3>> GrevilleGrid::jets(const std::vector<glm::dvec3>& points,
                                                       int derivatives) const
{
    const auto columns = static_cast<std::size_t>(tables_[1].count);
    const auto rows = static_cast<std::size_t>(tables_[0].order);
    std::vector<SurfaceJet<glm::dvec3>> out, line(columns);
    out.reserve(points.size());
    for (const Basis& a : tables_[0].basis) {
        std::fill(line.begin(), line.end(), SurfaceJet<glm::dvec3>{});
        for (std::size_t k = 0; k < rows; ++k) {
            const glm::dvec3* row =
                points.data() + (static_cast<std::size_t>(a.first) + k) * columns;
            for (std::size_t j = 0; j < columns; ++j) {
                line[j].value += a.value[k] * row[j];
                if (derivatives > 0) line[j].u += a.first_derivative[k] * row[j];
                if (derivatives > 1) line[j].uu += a.second_derivative[k] * row[j];
            }
        }
        for (const Basis& b : tables_[1].basis) {
            SurfaceJet<glm::dvec3> jet;
            for (std::size_t k = 0; k < static_cast<std::size_t>(tables_[1].order); ++k) {
                const SurfaceJet<glm::dvec3>& l = line[static_cast<std::size_t>(b.first) + k];
                jet.value += b.value[k] * l.value;
                if (derivatives < 1) continue;
                jet.u += b.value[k] * l.u;
                jet.v += b.first_derivative[k] * l.value;
                if (derivatives < 2) continue;
                jet.uu += b.value[k] * l.uu;
                jet.uv += b.first_derivative[k] * l.u;
                jet.vv += b.second_derivative[k] * l.value;
            }
            out.push_back(jet);
        }
    }
    return out;
}

} // namespace trivar
