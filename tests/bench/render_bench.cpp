// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "gpu/context.h"
#include "gpu/renderer.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

// About `triangles` triangles: a ring on the ground, seen from above.
Picture ring_of(int triangles)
{
    Picture picture;
    const int across = static_cast<int>(std::sqrt(triangles / 4.0));
    Instance ring;
    ring.mesh = make_ref(torus_mesh(1, 0.4, {2 * across, across}));
    picture.instances = {ring};
    picture.camera.eye = {2, -4, 2};
    return picture;
}

void report(benchmark::State& state, const Renderer& renderer)
{
    state.SetLabel(describe_context());
    for (const auto& stage : renderer.timings().stages)
        state.counters[stage.name + " ms"] = stage.time_ms;
}

// The final picture: 1280 x 720, four samples, everything on.
void render_final(benchmark::State& state)
{
    const HeadlessContext context;
    Renderer renderer;
    const Picture picture = ring_of(static_cast<int>(state.range(0)));
    renderer.draw(picture, {1280, 720});
    for (auto _ : state) benchmark::DoNotOptimize(renderer.render(picture, {1280, 720}));
    report(state, renderer);
}

// What a viewport shows while the camera moves.
void render_draft(benchmark::State& state)
{
    const HeadlessContext context;
    Renderer renderer;
    Picture picture = ring_of(static_cast<int>(state.range(0)));
    picture.draft = true;
    renderer.draw(picture, {1100, 700});
    for (auto _ : state) {
        renderer.draw(picture, {1100, 700});
        glFinish();
    }
    report(state, renderer);
}

// The same while the mesh changes: upload, shadow map and contact map come on top.
void render_draft_deforming(benchmark::State& state)
{
    const HeadlessContext context;
    Renderer renderer;
    Picture picture = ring_of(static_cast<int>(state.range(0)));
    picture.draft = true;
    renderer.draw(picture, {1100, 700});
    for (auto _ : state) {
        picture.instances[0].mesh = make_ref(Mesh(*picture.instances[0].mesh));
        renderer.draw(picture, {1100, 700});
        glFinish();
    }
    report(state, renderer);
}

// The baseline: an empty picture, only the backdrop and reading back.
void render_baseline_empty(benchmark::State& state)
{
    const HeadlessContext context;
    Renderer renderer;
    Picture nothing;
    nothing.samples = 1;
    nothing.draft = true;
    renderer.draw(nothing, {1280, 720});
    for (auto _ : state) benchmark::DoNotOptimize(renderer.render(nothing, {1280, 720}));
    report(state, renderer);
}

// By processor time of all threads too, which other programs on the machine disturb less.
void timed(benchmark::internal::Benchmark* bench)
{
    bench->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK(render_baseline_empty)->Apply(timed);
BENCHMARK(render_draft)->Arg(100'000)->Arg(1'000'000)->Apply(timed);
BENCHMARK(render_draft_deforming)->Arg(100'000)->Apply(timed);
BENCHMARK(render_final)->Arg(100'000)->Apply(timed);

} // namespace
} // namespace trivar::gpu
