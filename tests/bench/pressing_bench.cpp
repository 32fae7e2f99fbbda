// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/pressing.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

// 50 x 20 x 10 = 10^4 control points, all of them in the ball.
LaidVolume ten_thousand_points()
{
    const std::array<Knots, 3> axes{Knots::uniform(4, 50), Knots::uniform(4, 20),
                                    Knots::uniform(4, 10)};
    const Lattice box =
        lattice_at_rest(axes, glm::dmat4(5, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    return laid_volume(box, 0);
}

// One sample of a press: where its control points go; with the guard, also how far they may.
void press_sample(benchmark::State& state, bool guard, double radius)
{
    const Press press{.radius = radius, .samples = {{0.5, 0.5, 1, 0.01}}, .guard = guard};
    Pressing pressing(ten_thousand_points(), press);
    double amount = 0.001; // there and back, so that it stays what it was
    for (auto _ : state) {
        pressing.add({0.5, 0.5, 1, amount});
        amount = -amount;
    }
    state.SetItemsProcessed(state.iterations() * 10000);
}

void pressing_moves(benchmark::State& state)
{
    const Press press{.radius = 10, .samples = {{0.5, 0.5, 1, 0.01}}, .guard = false};
    const Pressing pressing(ten_thousand_points(), press);
    for (auto _ : state) benchmark::DoNotOptimize(pressing.moves({0.5, 0.5, 1, 0.001}));
    state.SetItemsProcessed(state.iterations() * 10000);
}

BENCHMARK(pressing_moves)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, all_10k_unguarded, false, 10.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, all_10k_guarded, true, 10.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, small_ball_guarded, true, 0.5)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace trivar
