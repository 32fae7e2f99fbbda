// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/springs.h"
#include "tests/placement/spring_dynamics.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <limits>
#include <numbers>

// A sheet of 64 x 32 nodes over two bumps and the gap between them, fixed at its ends: from where
// the rays fell to rest, until no node is farther than 1e-5 from complementarity.

namespace trivar {
namespace {

constexpr int rows = 64, columns = 32;
constexpr double tolerance = 1e-5;

ObstacleProblem bumps()
{
    SpringSheet sheet;
    sheet.rows = rows;
    sheet.columns = columns;
    for (int i = 0; i < rows; ++i) sheet.along.push_back(4.0 * i / (rows - 1));
    for (int j = 0; j < columns; ++j) sheet.across.push_back(2.0 * j / (columns - 1));
    for (const double x : sheet.along)
        for (const double y : sheet.across) {
            sheet.p0.emplace_back(x, y, 0);
            sheet.direction.emplace_back(0, 0, 1);
            const double bump = std::cos(std::numbers::pi * x / 2);
            sheet.lo.push_back(bump * bump - 0.1 * (y - 1) * (y - 1));
            sheet.hi.push_back(std::numeric_limits<double>::infinity());
        }
    ObstacleProblem problem = spring_problem(sheet);
    problem.free.assign(problem.size(), 1);
    for (int j = 0; j < columns; ++j)
        problem.free[sheet.index(0, j)] = problem.free[sheet.index(rows - 1, j)] = 0;
    return problem;
}

void springs_at_rest_by_projected_sor(benchmark::State& state)
{
    const ObstacleProblem problem = bumps();
    const std::vector<int> order = red_black(rows, columns);
    ObstacleSolution solution;
    while (state.KeepRunning())
        solution = projected_sor(problem, problem.lo, order, over_relaxation(rows, columns),
                                 tolerance / 30, 4000);
    state.counters["sweeps"] = solution.sweeps;
    state.counters["residual"] = residual(problem, solution.s);
}
BENCHMARK(springs_at_rest_by_projected_sor)->Unit(benchmark::kMillisecond);

// The thesis's way (Schein 2006, 2.3.2): both updates from the old values, at the longest stable
// step and near-critical damping.
void springs_at_rest_by_explicit_euler(benchmark::State& state)
{
    const ObstacleProblem problem = bumps();
    const SpringDynamics dynamics = settling_dynamics(100, rows);
    const double dt = 0.95 * stable_step_explicit(problem, dynamics);
    int steps = 0;
    std::vector<double> s;
    while (state.KeepRunning()) {
        s = problem.lo;
        std::vector<double> v(s.size(), 0.0), next = s;
        for (steps = 0; steps < 200000; ++steps) {
            for (std::size_t k = 0; k < s.size(); ++k) {
                if (!problem.free[k]) continue;
                const double a = dynamics.stiffness * problem.force(s, k) + dynamics.damping * v[k];
                next[k] = std::clamp(s[k] + dt * v[k], problem.lo[k], problem.hi[k]);
                v[k] = next[k] == problem.lo[k] && a < 0 ? 0 : v[k] + dt * a;
            }
            s.swap(next);
            if (steps % 50 == 0 && residual(problem, s) < tolerance) break;
        }
    }
    state.counters["steps"] = steps;
    state.counters["residual"] = residual(problem, s);
}
BENCHMARK(springs_at_rest_by_explicit_euler)->Unit(benchmark::kMillisecond);

void springs_at_rest_by_semi_implicit_euler(benchmark::State& state)
{
    const ObstacleProblem problem = bumps();
    const SpringDynamics dynamics = settling_dynamics(100, rows);
    SpringState springs;
    while (state.KeepRunning()) {
        springs = {problem.lo, std::vector<double>(problem.size(), 0.0), 0};
        while (springs.time_s < 60 &&
               (springs.time_s < 0.1 || residual(problem, springs.s) > tolerance))
            springs = stepped(problem, std::move(springs), dynamics, 0.1);
    }
    state.counters["seconds"] = springs.time_s;
    state.counters["residual"] = residual(problem, springs.s);
}
BENCHMARK(springs_at_rest_by_semi_implicit_euler)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
