// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/document/asset_store.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/scene_file.h"

#include <benchmark/benchmark.h>

// The ants of assets/scenes/ants_moebius, one object and those that follow it: what the next frame
// of them takes to work out, with all their vertices deformed, as the processor shows it, or left
// to the graphics card.
namespace trivar {
namespace {

Document ants(int count)
{
    const std::string scene = TRIVAR_SOURCE_DIR "/assets/scenes/ants_moebius.trivar";
    Document document = SceneFile::copy_of(scene).document();
    Travel travel = object(document, 2).travel;
    travel.followers = count - 1;
    PlacementParameters p = object(document, 2).stroke->parameters;
    p.fill = std::min(p.fill, 0.9 / count); // none stands in another
    document = after(document, EditPlacement{2, p, {}, {}});
    return after(document, SetTravel{{2}, travel});
}

void procession(benchmark::State& state, bool deformed)
{
    const Document document = ants(static_cast<int>(state.range(0)));
    Evaluator evaluate(std::make_shared<const AssetStore>(TRIVAR_SOURCE_DIR "/assets/scenes"));
    std::size_t vertices = 0, meshes = 0;
    double frame = 1;
    const auto show = [&] {
        Evaluation evaluated = evaluate(document, frame);
        frame = frame < 200 ? frame + 1 : 1;
        if (deformed) deform_parts(evaluated);
        vertices = 0;
        meshes = evaluated.objects.at(2)->parts.size();
        for (const Part& part : evaluated.objects.at(2)->parts) vertices += part.vertex_count();
    };
    show();
    for (auto _ : state) show();
    state.counters["meshes"] = static_cast<double>(meshes);
    state.counters["vertices"] = static_cast<double>(vertices);
}
void counts(benchmark::internal::Benchmark* each)
{
    each->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime()
        ->Arg(1)
        ->Arg(7)
        ->Arg(100)
        ->Arg(300);
}
BENCHMARK_CAPTURE(procession, deformed, true)->Apply(counts);
BENCHMARK_CAPTURE(procession, left_to_the_card, false)->Apply(counts);

} // namespace
} // namespace trivar
