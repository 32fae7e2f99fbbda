// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/injectivity.h"

#include "core/ffd/guard.h"
#include "core/spline/bezier_cell.h"
#include "core/spline/derivative.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

// F in every cell, as control points in world space.
std::vector<BezierCell> world_cells(const Lattice& lattice)
{
    std::vector<BezierCell> cells = bezier_cells(lattice.displacement);
    for (BezierCell& cell : cells) {
        auto p = cell.points.begin();
        const glm::dvec3 steps(cell.orders - 1), edge = cell.hi - cell.lo;
        for (int i = 0; i < cell.orders.x; ++i)
            for (int j = 0; j < cell.orders.y; ++j)
                for (int k = 0; k < cell.orders.z; ++k) {
                    const glm::dvec3 uvw = cell.lo + edge * glm::dvec3(i, j, k) / steps;
                    *p++ += glm::dvec3(lattice.rest * glm::dvec4(uvw, 1));
                }
    }
    return cells;
}

// A map may jump where a knot is repeated `order` times.
bool continuous_over_a_box(const std::array<Knots, 3>& axes)
{
    return std::all_of(axes.begin(), axes.end(), [](const Knots& axis) {
        const auto& k = axis.values();
        const auto order = static_cast<std::size_t>(axis.order());
        for (std::size_t i = order; i + order < k.size(); ++i)
            if (k[i] > axis.begin() && k[i] < axis.end() && k[i] == k[i + order - 1]) return false;
        return axis.closure() == Closure::open;
    });
}

// F(x) - F(y) = A (I + E)(x - y) with |E| < 1, where A is the mean of J: then only x = y meet. The
// control points of a derivative bound it.
bool nearly_affine(const Lattice& lattice)
{
    std::array<std::vector<glm::dvec3>, 3> slopes;
    glm::dmat3 a(0);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<glm::dvec3>& s = slopes[static_cast<std::size_t>(axis)];
        s = derivative(lattice.displacement, axis).points;
        for (glm::dvec3& p : s) {
            p += glm::dvec3(lattice.rest[axis]);
            a[axis] += p / static_cast<double>(s.size());
        }
    }
    const double volume = glm::determinant(a);
    if (!(std::abs(volume) > 0) || !std::isfinite(volume)) return false;
    // Each axis by the length it has in the world, so that it does not matter how fast it is run.
    const glm::dvec3 speed(glm::length(a[0]), glm::length(a[1]), glm::length(a[2]));
    const glm::dmat3 inverse = glm::inverse(a);
    glm::dvec3 worst(0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit(0);
        unit[axis] = 1;
        for (const glm::dvec3& p : slopes[static_cast<std::size_t>(axis)]) {
            const double off = glm::length(speed * (inverse * p - unit)) / speed[axis];
            if (!(off <= worst[axis])) worst[axis] = off;
        }
    }
    return glm::length(worst) < 1 - 1e-9;
}

} // namespace

double smallest_jacobian(const Lattice& lattice, int samples)
{
    assert(samples >= 2);
    double least = std::numeric_limits<double>::infinity();
    for (const BezierCell& cell : world_cells(lattice))
        for (int i = 0; i < samples; ++i)
            for (int j = 0; j < samples; ++j)
                for (int k = 0; k < samples; ++k) {
                    const glm::dvec3 x = glm::dvec3(i, j, k) / static_cast<double>(samples - 1);
                    glm::dmat3 jacobian = evaluate(cell, x).jacobian;
                    for (int a = 0; a < 3; ++a) jacobian[a] /= cell.hi[a] - cell.lo[a];
                    least = std::min(least, glm::determinant(jacobian));
                }
    return least;
}

Injectivity check_injectivity(const Lattice& lattice, int depth)
{
    const CellVerdicts verdicts = judge(lattice);
    std::vector<int> doubtful;
    for (std::size_t c = 0; c < verdicts.of.size(); ++c)
        if (verdicts.of[c] != Verdict::proven_good) doubtful.push_back(static_cast<int>(c));
    // A zero of det J costs boxes along a whole surface; this many show where it is.
    const Halving halving{depth, 512};
    const CellGrid grid(lattice.displacement.axes);
    std::vector<std::vector<DoubtfulPart>> parts(doubtful.size());
    each_determinant(grid, lattice, doubtful, [&](std::size_t i, const CellDeterminant& det) {
        parts[i] = doubtful_parts(grid.place(static_cast<std::size_t>(doubtful[i])), det,
                                  verdicts.sign, halving);
    });
    Injectivity out;
    for (const auto& of_cell : parts)
        out.parts.insert(out.parts.end(), of_cell.begin(), of_cell.end());
    for (const DoubtfulPart& part : out.parts)
        if (out.local != Verdict::proven_bad) out.local = part.verdict;
    out.global = continuous_over_a_box(lattice.displacement.axes) && nearly_affine(lattice);
    return out;
}

} // namespace trivar
