// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace trivar {

// An ObstacleProblem asks to minimise 1/2 s.A s - b.s subject to lo <= s <= hi over the free
// unknowns; all others keep their value. A is symmetric positive semidefinite, in rows of (column,
// value) with the diagonal apart. Springs, membrane and live animation solve such problems.
struct ObstacleProblem {
    std::vector<int> row_begin{0}; // #unknowns + 1
    std::vector<int> column;
    std::vector<double> value;
    std::vector<double> diagonal, right, lo, hi;
    std::vector<char> free;

    std::size_t size() const { return diagonal.size(); }
    // The value of b - A s in one row: the force that pulls s up.
    double force(const std::vector<double>& s, std::size_t row) const;
};

struct ObstacleSolution {
    std::vector<double> s;
    int sweeps = 0;
    double residual = 0; // largest |s - clamp(s + force / diagonal, lo, hi)| of the free unknowns
};

// Solves by projected successive over-relaxation. Cryer 1971.
//   s            the start, #unknowns
//   order        of the unknowns in a sweep
//   omega        0 < omega < 2
//   tolerance    it ends when no unknown of a sweep moves by more
//   most_sweeps  or after these
ObstacleSolution projected_sor(const ObstacleProblem& problem, std::vector<double> s,
                               const std::vector<int>& order, double omega, double tolerance,
                               int most_sweeps);

double residual(const ObstacleProblem& problem, const std::vector<double>& s);

} // namespace trivar
