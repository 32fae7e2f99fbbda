// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/cell_search.h"

namespace trivar {
namespace {

// The step that solves (J^T J + lambda I) step = -gradient in the directions that stay inside the
// box; those that a face stops are left out.
glm::dvec3 step_inside(const glm::dmat3& jacobian, const glm::dvec3& gradient,
                       const glm::bvec3& stopped, double lambda)
{
    glm::dmat3 a = glm::transpose(jacobian) * jacobian;
    glm::dvec3 right = -gradient;
    for (int i = 0; i < 3; ++i) {
        a[i][i] += lambda;
        if (!stopped[i]) continue;
        for (int k = 0; k < 3; ++k) a[i][k] = a[k][i] = 0;
        a[i][i] = 1;
        right[i] = 0;
    }
    return glm::inverse(a) * right;
}

double squared_size(const glm::dmat3& j)
{
    return glm::dot(j[0], j[0]) + glm::dot(j[1], j[1]) + glm::dot(j[2], j[2]);
}

} // namespace

CellSearch search_cell(const BezierCell& cell, const glm::dvec3& p, glm::dvec3 x, double enough)
{
    constexpr int most_steps = 60;
    // Cosine between what is left and every way on: below it, what a step gains is lost in the
    // rounding of the residual.
    constexpr double stationary = 1e-7;
    CellValue here = evaluate(cell, x);
    CellSearch best{x, glm::distance(here.value, p), false};
    double lambda = 0;
    for (int i = 0; i < most_steps && best.residual > 1e-3 * enough; ++i) {
        const glm::dvec3 gradient = glm::transpose(here.jacobian) * (here.value - p);
        glm::bvec3 stopped(false);
        glm::dvec3 way = gradient;
        for (int k = 0; k < 3; ++k) {
            stopped[k] =
                (best.x[k] <= 0 && gradient[k] >= 0) || (best.x[k] >= 1 && gradient[k] <= 0);
            if (stopped[k]) way[k] = 0;
        }
        const double size = squared_size(here.jacobian);
        best.settled = glm::length(way) <= stationary * std::sqrt(size) * best.residual ||
                       lambda > 1e12 * size;
        if (best.settled) break;

        const glm::dvec3 step = step_inside(here.jacobian, gradient, stopped, lambda);
        const glm::dvec3 next = glm::clamp(best.x + step, glm::dvec3(0), glm::dvec3(1));
        const CellValue there = evaluate(cell, next);
        const double residual = glm::distance(there.value, p);
        if (residual < best.residual) { // false for a NaN from a singular Jacobian
            best = {next, residual, false};
            here = there;
            lambda = lambda > 1e-10 * size ? lambda / 10 : 0;
        } else {
            if (best.residual <= enough) break;
            lambda = std::max(10 * lambda, 1e-6 * size);
        }
    }
    best.settled = best.settled || best.residual <= enough;
    return best;
}

} // namespace trivar
