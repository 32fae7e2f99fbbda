// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/guard.h"
#include "core/ffd/overlap.h"
#include "core/ffd/resolution.h"
#include "tests/support/splines.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

// 20 x 12 x 8 control points, tri-cubic: 765 cells.
Lattice pressed_lattice()
{
    return {testing::random_volume(
                {Knots::uniform(4, 20), Knots::uniform(4, 12), Knots::uniform(4, 8)}, 2, 0.01),
            glm::dmat4(1)};
}

// A point in the middle, which touches 64 cells. Past its neighbours the guard has to search.
PointMove drag(bool too_far)
{
    return {{9, 6, 4}, {too_far ? 0.3 : 0.01, 0.01, -0.01}};
}

void guard_whole_lattice(benchmark::State& state)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    const Lattice lattice = pressed_lattice();
    for (auto _ : state) benchmark::DoNotOptimize(judge(lattice).good());
}

void guard_touched_cells(benchmark::State& state)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    const PointMove move = drag(false);
    const Lattice before = pressed_lattice(), now = moved(before, std::span(&move, 1));
    CellVerdicts verdicts = judge(before);
    for (auto _ : state) verdicts = judged_again(std::move(verdicts), now, std::span(&move, 1));
}

void guard_share(benchmark::State& state)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    const PointMove move = drag(state.range(1) != 0);
    const Lattice lattice = pressed_lattice();
    const CellVerdicts verdicts = judge(lattice);
    for (auto _ : state)
        state.counters["share"] = certified_share(lattice, verdicts, std::span(&move, 1)).share;
}

void overlap_of_far_parts(benchmark::State& state)
{
    const Lattice lattice = pressed_lattice();
    for (auto _ : state) state.counters["pairs"] = overlap(lattice).pairs;
}

BENCHMARK(overlap_of_far_parts)->Unit(benchmark::kMillisecond);

// 100 x 100 x 100 control points.
const Lattice& million_points()
{
    static const Lattice lattice{
        testing::random_volume(
            {Knots::uniform(4, 100), Knots::uniform(4, 100), Knots::uniform(4, 100)}, 2, 0.001),
        glm::dmat4(1)};
    return lattice;
}

void resolution_refined(benchmark::State& state)
{
    const auto axis = static_cast<std::size_t>(state.range(0));
    AxisKnots knots;
    knots[axis] = {0.501};
    for (auto _ : state) benchmark::DoNotOptimize(refined(million_points(), knots));
}

void resolution_coarsened(benchmark::State& state)
{
    for (auto _ : state)
        state.counters["deviation"] =
            coarsened(million_points(), static_cast<int>(state.range(0)), 80).deviation;
}

void resolution_for_a_sphere(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(knots_for_sphere(million_points(), glm::dvec3(0.5), 0.01));
}

BENCHMARK(resolution_refined)->ArgName("axis")->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(resolution_coarsened)->ArgName("axis")->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(resolution_for_a_sphere)->Unit(benchmark::kMillisecond);
BENCHMARK(guard_whole_lattice)->ArgNames({"threads"})->Args({1})->Args({2})->UseRealTime();
BENCHMARK(guard_touched_cells)->ArgNames({"threads"})->Args({1})->Args({2})->UseRealTime();
BENCHMARK(guard_share)
    ->ArgNames({"threads", "too_far"})
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->UseRealTime();

} // namespace
} // namespace trivar
