// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/evaluation/evaluate.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

// Measures one move of the mouse while a control point of a lattice is dragged: the command, the
// volume with its guard and the model in it, of 20 x 12 x 8 points and some 100,000 vertices,
// without the picture. Twisted: no vertex is where it was at rest. Laid: box and model lie on a
// stroke, whose volume bends the result of the box further.
enum class Box20 { at_rest, twisted, laid };

Place along_a_line(Id lattice, Id ground)
{
    Place place{lattice, {}, {}, {ground}};
    Camera& camera = place.sketch.camera;
    camera.eye = {0, -0.01, 20};
    camera.target = {0, 0, 0};
    camera.perspective = false;
    camera.height_world = 10;
    camera.size_px = {1000, 1000};
    for (int i = 0; i <= 40; ++i)
        place.sketch.samples.push_back({{300 + 10.0 * i, 500 + 2 * (i % 20)}, 0.02 * i});
    return place;
}

void lattice_drag(benchmark::State& state, Box20 box, bool deformed_here)
{
    keep_freed_memory(); // as the program does
    Document document =
        after(Document{}, AddSphere{.shape = {.radius = 0.5, .segments = 448, .rings = 224}});
    document = after(document, AddLattice{.objects = {1}, .shape = {.grid = {20, 12, 8}}});
    if (box == Box20::twisted) document = after(document, WarpVolume{2, {.twist_deg = 20}});
    if (box == Box20::laid) {
        document = after(document, AddPlane{.shape = {.size = {9, 9}}});
        document = after(document, along_a_line(2, 3));
    }
    Evaluator evaluator(std::make_shared<AssetStore>(""));
    PointShift shift{.points = {{10, 6, 7}}};
    int step = 0;
    std::size_t vertices = 0;
    double height = 0;
    const auto move = [&] {
        shift.by.z = 0.001 * (++step % 50); // as a drag that comes and goes
        Evaluation shown = evaluator(after(document, MovePoints{.object = 2, .shift = shift}), 1);
        if (deformed_here) deform_parts(shown);
        if (deformed_here)
            for (const glm::vec3& p : shown.objects.at(1)->parts.front().mesh()->positions)
                height = std::max<double>(height, p.z);
        vertices = shown.objects.at(1)->parts.front().rest->vertex_count();
    };
    move();
    for (auto _ : state) move();
    state.counters["highest m"] = height; // more than the radius: it was deformed
    state.counters["vertices"] = static_cast<double>(vertices);
}

BENCHMARK_CAPTURE(lattice_drag, deformed_by_the_card, Box20::at_rest, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lattice_drag, deformed_here, Box20::at_rest, true)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lattice_drag, twisted_deformed_by_the_card, Box20::twisted, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lattice_drag, twisted_deformed_here, Box20::twisted, true)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lattice_drag, laid_deformed_by_the_card, Box20::laid, false)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(lattice_drag, laid_deformed_here, Box20::laid, true)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
