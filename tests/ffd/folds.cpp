// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ffd/folds.h"

#include "tests/support/bezier_values.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace trivar::testing {
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
                    glm::dmat3 jacobian = cell_value(cell, x).jacobian;
                    for (int a = 0; a < 3; ++a) jacobian[a] /= cell.hi[a] - cell.lo[a];
                    least = std::min(least, glm::determinant(jacobian));
                }
    return least;
}

Verdict verdict_of(const Lattice& lattice)
{
    const CellVerdicts verdicts = judge(lattice);
    if (verdicts.good()) return Verdict::proven_good;
    return std::ranges::count(verdicts.of, Verdict::proven_bad) > 0 ? Verdict::proven_bad
                                                                    : Verdict::unknown;
}

} // namespace trivar::testing
