// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/stretch_bound.h"

#include "core/base/finite.h"
#include "core/base/index.h"
#include "core/base/parallel.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double rounding_of_stretch = 1e-12; // relative, of all that follows

double spectral_norm(const glm::dmat3& m)
{
    Eigen::Matrix3d a;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) a(r, c) = m[c][r];
    return a.jacobiSvd().singularValues()[0];
}

glm::dvec3 row_of(const glm::dmat4& m, int r)
{
    return {m[0][r], m[1][r], m[2][r]};
}

// A Slope is the mean of the derivatives along one axis, by the parameters of the cell, that the
// Bezier points of a cell give, and the largest distance of one of them from it.
struct Slope {
    glm::dvec3 mean{0};
    double radius = 0;
};
Slope slope_along(const DisplacementCells::Cell& cell, const glm::ivec3& n, int axis)
{
    if (cell.beyond[axis]) return {};
    const glm::ivec3 step(axis == 0 ? n.y * n.z : 0, axis == 1 ? n.z : 0, axis == 2 ? 1 : 0);
    glm::ivec3 counts = n;
    --counts[axis];
    const double scale = (cell.mirrored[axis] ? -1.0 : 1.0) * (n[axis] - 1) / cell.size[axis];
    const auto each = [&](const auto& use) {
        for (int i = 0; i < counts.x; ++i)
            for (int j = 0; j < counts.y; ++j)
                for (int k = 0; k < counts.z; ++k) {
                    const int p = (i * n.y + j) * n.z + k;
                    use(scale * glm::dvec3(cell.points[at(p + step[axis])] - cell.points[at(p)]));
                }
    };
    Slope out;
    each([&](const glm::dvec3& d) { out.mean += d; });
    out.mean /= counts.x * counts.y * counts.z;
    each([&](const glm::dvec3& d) {
        out.radius = std::max(out.radius, glm::distance(d, out.mean));
    });
    return out;
}

double stretch_of_cell(const DisplacementCells& cells, const Embedding& embedding,
                       const glm::ivec3& slabs, DisplacementCells::Cell& cell)
{
    cells.load(slabs, cell);
    glm::dmat3 jacobian(embedding.to_rest);
    double squared = 0;
    for (int a = 0; a < 3; ++a) {
        const Slope slope = slope_along(cell, cells.orders(), a);
        const glm::dvec3 row = row_of(embedding.to_uvw, a);
        jacobian += glm::outerProduct(slope.mean, row);
        squared += slope.radius * slope.radius * glm::dot(row, row);
    }
    return (spectral_norm(jacobian) + std::sqrt(squared)) * (1 + rounding_of_stretch);
}

} // namespace

StretchBound::Axis StretchBound::axis_of(const AxisSlabs& slabs)
{
    if (slabs.open()) return {slabs, -1, slabs.count() + 2};
    return {slabs, 0, slabs.closure() == Closure::twisted ? 2 * slabs.count() : slabs.count()};
}

StretchBound::StretchBound(const DisplacementCells& cells, const Embedding& embedding)
    : axes_{axis_of(cells.axis(0)), axis_of(cells.axis(1)), axis_of(cells.axis(2))}
{
    const std::size_t rows = at(axes_[1].count) * at(axes_[2].count);
    stretch_.resize(at(axes_[0].count) * rows);
    parallel_blocks(stretch_.size(), 64, [&](std::size_t begin, std::size_t end) {
        DisplacementCells::Cell cell;
        for (std::size_t c = begin; c < end; ++c) {
            const glm::ivec3 from(static_cast<int>(c / rows),
                                  static_cast<int>(c % rows) / axes_[2].count,
                                  static_cast<int>(c % rows) % axes_[2].count);
            const glm::ivec3 first(axes_[0].first, axes_[1].first, axes_[2].first);
            stretch_[c] = stretch_of_cell(cells, embedding, from + first, cell);
        }
    });
    for (const double each : stretch_) most_ = std::max(most_, each);
}

double StretchBound::over(const glm::dvec3& least_uvw, const glm::dvec3& most_uvw) const
{
    glm::ivec3 first, counts;
    for (int a = 0; a < 3; ++a) {
        const Axis& axis = axes_[at(a)];
        const auto [lo, hi] =
            std::minmax({axis.slabs.upper(least_uvw[a]), axis.slabs.lower(most_uvw[a])});
        for (int slab = lo; slab < hi && slab - lo < axis.count; ++slab)
            if (axis.slabs.joint(slab) == AxisSlabs::Joint::jump) return infinite;
        first[a] = lo - axis.first;
        counts[a] = std::min(hi - lo + 1, axis.count);
    }
    const auto wrapped = [&](int a, int slab) {
        const int count = axes_[at(a)].count;
        return at((slab % count + count) % count);
    };
    double most = 0;
    for (int i = 0; i < counts.x; ++i)
        for (int j = 0; j < counts.y; ++j)
            for (int k = 0; k < counts.z; ++k)
                most = std::max(most, stretch_[(wrapped(0, first.x + i) * at(axes_[1].count) +
                                                wrapped(1, first.y + j)) *
                                                   at(axes_[2].count) +
                                               wrapped(2, first.z + k)]);
    return most;
}

} // namespace trivar
