// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "core/commands/objects/shape.h"
#include "core/commands/placement/place.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/pressing.h"
#include "core/placement/shaper.h"
#include "core/scene/scene_file.h"

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

// Measures one move of the mouse while the ball is pressed into a placed crocodile of 21,511
// vertices, in a volume of 50 x 20 x 10 points: the command, the volume with its guard, and the
// model in it, deformed here or left to the card, without the picture.
void press_drag(benchmark::State& state, bool deformed_here)
{
    keep_freed_memory(); // as the program does
    const std::string folder = TRIVAR_SOURCE_DIR "/assets/scenes";
    const SceneFile scene(folder + "/crocodile_pressed.trivar");
    Document document = scene.document();
    const Id id = 2;
    document = after(document, Unshape{id, {}});
    PlacementParameters dense = object(document, id).stroke->parameters;
    dense.grid = {50, 20, 10};
    document = after(document, EditPlacement{id, dense, {}, {}});
    Evaluator evaluator(std::make_shared<AssetStore>(folder));
    Press press{.radius = 0.34, .samples = {{0.5, 0.5, 1, 0}}};
    int step = 0;
    double largest = 0;
    const auto move = [&] {
        press.samples.front().w = 0.001 * (++step % 100); // as a drag that comes and goes
        Evaluation shown = evaluator(after(document, PressVolume{id, press}), 1);
        if (deformed_here) deform_parts(shown);
        largest = std::max(largest, shown.objects.at(id)->shaped->steps.back().done);
    };
    move();
    for (auto _ : state) move();
    state.counters["deepest m"] = largest;
}

BENCHMARK_CAPTURE(press_drag, deformed_by_the_card, false)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(press_drag, deformed_here, true)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(pressing_moves)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, all_10k_unguarded, false, 10.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, all_10k_guarded, true, 10.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(press_sample, small_ball_guarded, true, 0.5)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace trivar
