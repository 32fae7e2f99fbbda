// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/obstacle.h"

#include <algorithm>
#include <cmath>

namespace trivar {

double ObstacleProblem::force(const std::vector<double>& s, std::size_t row) const
{
    double f = right[row] - diagonal[row] * s[row];
    for (int e = row_begin[row]; e < row_begin[row + 1]; ++e) {
        const auto k = static_cast<std::size_t>(e);
        f -= value[k] * s[static_cast<std::size_t>(column[k])];
    }
    return f;
}

double residual(const ObstacleProblem& problem, const std::vector<double>& s)
{
    double worst = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        if (!problem.free[i] || !(problem.diagonal[i] > 0)) continue;
        const double wanted = std::clamp(s[i] + problem.force(s, i) / problem.diagonal[i],
                                         problem.lo[i], problem.hi[i]);
        worst = std::max(worst, std::abs(wanted - s[i]));
    }
    return worst;
}

ObstacleSolution projected_sor(const ObstacleProblem& problem, std::vector<double> s,
                               const std::vector<int>& order, double omega, double tolerance,
                               int most_sweeps)
{
    ObstacleSolution out;
    std::vector<int> rows;
    for (const int i : order) {
        const auto k = static_cast<std::size_t>(i);
        if (problem.free[k] && problem.diagonal[k] > 0) rows.push_back(i);
    }
    while (out.sweeps < most_sweeps) {
        ++out.sweeps;
        double largest = 0;
        for (const int row : rows) {
            const auto i = static_cast<std::size_t>(row);
            const double wanted = s[i] + omega * problem.force(s, i) / problem.diagonal[i];
            const double next = std::clamp(wanted, problem.lo[i], problem.hi[i]);
            largest = std::max(largest, std::abs(next - s[i]));
            s[i] = next;
        }
        if (largest <= tolerance) break;
    }
    out.residual = residual(problem, s);
    out.s = std::move(s);
    return out;
}

} // namespace trivar
