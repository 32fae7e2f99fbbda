// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/guard.h"
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

BENCHMARK(guard_whole_lattice)->ArgNames({"threads"})->Args({1})->Args({2})->UseRealTime();
BENCHMARK(guard_touched_cells)->ArgNames({"threads"})->Args({1})->Args({2})->UseRealTime();
BENCHMARK(guard_share)
    ->ArgNames({"threads", "too_far"})
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->UseRealTime();

} // namespace
} // namespace trivar
