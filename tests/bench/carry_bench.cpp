// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/document/asset_store.h"
#include "core/evaluation/evaluate.h"

#include <benchmark/benchmark.h>
#include <cmath>

// A table on which models lie on strokes that belong to it, and what the next frame takes to work
// out while the table is moved and turned: their volumes are carried, and nothing is laid again.
namespace trivar {
namespace {

constexpr Id table = 1;

Sketch line_across(double share)
{
    Sketch sketch;
    sketch.camera.eye = {0, -0.01, 20};
    sketch.camera.target = {0, 0, 0};
    sketch.camera.perspective = false;
    sketch.camera.height_world = 10;
    sketch.camera.size_px = {1000, 1000};
    for (int i = 0; i <= 40; ++i)
        sketch.samples.push_back(
            {{100 + 20.0 * i, 50 + 900 * share + 10 * std::sin(0.3 * i)}, 0.02 * i});
    return sketch;
}

Document loaded_table(int count)
{
    Document document = after(Document{}, AddPlane{.shape = {.size = {12, 12}}});
    for (int i = 0; i < count; ++i) {
        AddCylinder model;
        model.shape = {.radius = 0.1, .height = 2, .segments = 100, .stacks = 100};
        document = after(document, model);
        const Id id = document.next_id - 1;
        Place place{id, line_across((i + 0.5) / count), {}, {table}};
        place.parameters.grid = {30, 6, 3};
        place.parameters.along = LengthAxis::z;
        place.parameters.width = place.parameters.height = 0.2;
        document = after(document, place);
        document = after(document, Attach{id});
    }
    return document;
}

void carried_models(benchmark::State& state)
{
    Document document = loaded_table(static_cast<int>(state.range(0)));
    Evaluator evaluate(std::make_shared<const AssetStore>(""));
    double turn = 0;
    std::size_t vertices = 0, rays = 0;
    const auto show = [&] {
        turn += 0.5;
        document =
            after(document,
                  SetTransform{table,
                               {.translation = {0.01 * turn, 0, 0}, .rotation_deg = {0, 0, turn}}});
        const Evaluation evaluated = evaluate(document);
        vertices = 0;
        for (const auto& [id, object] : evaluated.objects)
            for (const Part& part : object->parts) vertices += part.vertex_count();
        for (const Timings::Stage& stage : evaluated.timings.stages)
            if (stage.name == "rays") ++rays;
    };
    show();
    rays = 0;
    for (auto _ : state) show();
    state.counters["vertices"] = static_cast<double>(vertices);
    state.counters["frames_with_rays"] = static_cast<double>(rays);
}
BENCHMARK(carried_models)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Arg(1)
    ->Arg(20)
    ->Arg(100);

} // namespace
} // namespace trivar
