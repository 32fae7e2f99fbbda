// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/deform.h"
#include "core/mesh/primitives.h"
#include "core/placement/placement.h"
#include "core/placement/springs.h"
#include "core/rays/ray_scene.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <limits>
#include <random>

namespace trivar {
namespace {

// Rough ground of 2 x 500 x 500 triangles, 4 m wide.
const RayScene& terrain()
{
    static const RayScene scene = [] {
        Mesh mesh = plane_mesh({4, 4}, {500, 500});
        for (glm::vec3& p : mesh.positions)
            p.z = 0.15f * std::sin(3 * p.x + 1) * std::sin(4 * p.y) +
                  0.04f * std::sin(13 * p.x) * std::cos(11 * p.y) +
                  0.004f * std::sin(61 * p.x + 5 * p.y) * std::sin(53 * p.y);
        mesh.normals.clear();
        return RayScene({{std::make_shared<const RayMesh>(make_ref(std::move(mesh)))}});
    }();
    return scene;
}

Sketch wavy_stroke()
{
    Sketch out;
    out.camera.eye = {1, -4, 3};
    out.camera.size_px = {1500, 1000};
    for (int i = 0; i <= 300; ++i) {
        const double x = i / 150.0 - 1;
        out.samples.push_back({project(out.camera, {x, 0.2 * std::sin(3 * x), 0}).p_px, 0.01 * i});
    }
    return out;
}

// Stroke to deformed model: everything between the last mouse event and the upload.
void stroke_to_result(benchmark::State& state)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    const PlacementParameters p{.grid = {64, 32, 4},
                                .offset = static_cast<double>(state.range(1)),
                                .sharp = state.range(2) != 0};
    const Sketch sketch = wavy_stroke();
    const Ref<Mesh> model = make_ref(box_mesh({10, 2, 1}, {100, 40, 20}));
    terrain();
    Timings timings;
    double penetration = 0;
    for (auto _ : state) {
        const Placement placed = place(sketch, p, bounding_box(*model), terrain(), timings);
        timed(timings, "deform", [&] {
            benchmark::DoNotOptimize(
                Deformer(model, placed.embedding, placed.volume.displacement.axes)(placed.volume));
        });
        penetration = placed.report.penetration;
    }
    for (const Timings::Stage& stage : timings.stages)
        state.counters[stage.name + "_ms"] =
            stage.time_ms / static_cast<double>(state.iterations());
    state.counters["penetration"] = penetration;
}
BENCHMARK(stroke_to_result)
    ->ArgNames({"threads", "offset", "sharp"})
    ->ArgsProduct({{1, 2}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// The same over the edge of a box, 1.2 m wide and seen from the corner.
void stroke_over_an_edge(benchmark::State& state)
{
    const ThreadLimit limit(2);
    static const RayScene box(
        {{std::make_shared<const RayMesh>(make_ref(box_mesh({1.2, 3, 1.2}, {60, 60, 60})))}});
    const PlacementParameters p{
        .width = 0.4, .height = 0.2, .grid = {64, 32, 4}, .sharp = state.range(0) != 0};
    Sketch sketch;
    sketch.camera.eye = {4, -0.6, 3.6};
    sketch.camera.size_px = {1500, 1000};
    for (int i = 0; i <= 200; ++i) {
        const double along = i / 200.0 - 0.5;
        const glm::dvec3 p_world = along < 0 ? glm::dvec3(0.6 + along, along / 3, 0.6)
                                             : glm::dvec3(0.6, along / 3, 0.6 - along);
        sketch.samples.push_back({project(sketch.camera, p_world).p_px, 0.01 * i});
    }
    Timings timings;
    const Box model{{-5, -1, 0}, {5, 1, 1}};
    for (auto _ : state) {
        const Placement placed = place(sketch, p, model, box, timings);
        state.counters["control_points"] =
            static_cast<double>(placed.volume.displacement.points.size());
        state.counters["penetration"] = placed.report.penetration;
    }
}
BENCHMARK(stroke_over_an_edge)
    ->ArgName("sharp")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void rays(benchmark::State& state)
{
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    std::vector<Ray> rays;
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 from(uniform(random), uniform(random), 3);
        const glm::dvec3 to(uniform(random), uniform(random), 0);
        rays.push_back({from, glm::normalize(to - from)});
    }
    for (auto _ : state) benchmark::DoNotOptimize(terrain().hits(rays));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(rays)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
