// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "tests/support/draw_calls.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

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

// Draws the viewport as while the camera moves.
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

// A field of so many rings of 500 vertices, in one picture's passes.
Picture field_of(int across, bool copies)
{
    Picture picture;
    picture.camera.eye = {0, -1.2 * across, across};
    picture.samples = 1;
    Instance ring;
    ring.mesh = make_ref(torus_mesh(0.3, 0.12, {24, 19}));
    std::vector<Copy> places;
    for (int i = 0; i < across * across; ++i) {
        const glm::dvec3 place(i % across - across / 2, i / across - across / 2, 0);
        places.push_back({glm::translate(glm::dmat4(1), place), i + 1});
    }
    if (copies) {
        ring.copies = make_ref(places);
        picture.instances = {ring};
        return picture;
    }
    for (const Copy& place : places) {
        ring.to_world = place.to_instance;
        ring.id = place.id;
        picture.instances.push_back(ring);
    }
    return picture;
}

void render_field(benchmark::State& state, bool copies)
{
    const HeadlessContext context;
    Renderer renderer;
    const Picture picture = field_of(100, copies);
    renderer.draw(picture, {1280, 720});
    int calls = 0;
    for (auto _ : state) {
        const trivar::testing::DrawCalls counted;
        renderer.draw(picture, {1280, 720});
        glFinish();
        calls = counted.count;
    }
    report(state, renderer);
    state.counters["draw calls"] = calls;
    state.counters["vertices a copy"] =
        static_cast<double>(picture.instances.front().mesh->vertex_count());
}

// 10,000 copies of a mesh, and as many instances of it.
void render_copies(benchmark::State& state)
{
    render_field(state, true);
}
void render_baseline_instances(benchmark::State& state)
{
    render_field(state, false);
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

// Measures the processor time of all threads too, which other programs on the machine disturb less.
void timed(benchmark::internal::Benchmark* bench)
{
    bench->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK(render_baseline_empty)->Apply(timed);
BENCHMARK(render_draft)->Arg(100'000)->Arg(1'000'000)->Apply(timed);
BENCHMARK(render_draft_deforming)->Arg(100'000)->Apply(timed);
BENCHMARK(render_copies)->Apply(timed);
BENCHMARK(render_baseline_instances)->Apply(timed);
BENCHMARK(render_final)->Arg(100'000)->Apply(timed);

} // namespace
} // namespace trivar::gpu
