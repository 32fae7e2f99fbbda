// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_summary.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "tests/casting/cast_ray.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::gpu {
namespace {

// A head of so many voxels along each axis, 12 bits: air, soft tissue with folds, a skull.
Ref<VoxelGrid> head_of(int size)
{
    VoxelGrid grid;
    grid.size = glm::ivec3(size);
    std::vector<std::uint16_t> samples;
    samples.reserve(grid.count());
    for (int z = 0; z < size; ++z)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 p = glm::dvec3(x, y, z) / (0.5 * size) - 1.0;
                const double r = glm::length(p * glm::dvec3(1.2, 1, 0.95)),
                             fold = 0.015 * std::sin(9 * p.x + 5 * p.z) * std::sin(11 * p.y);
                const auto step = [](double a) { return 1 / (1 + std::exp(-120 * a)); };
                const double value =
                    900 * step(0.8 + fold - r) + 1600 * step(0.7 + fold - r) * step(r - 0.6 - fold);
                samples.push_back(static_cast<std::uint16_t>(20 + value));
            }
    grid.samples = std::move(samples);
    return make_ref(std::move(grid));
}

Ref<Casting> casting_of_head(int size)
{
    const Ref<VoxelGrid> grid = head_of(size);
    const VolumeSummary summary = summary_of(*grid);
    return make_ref(casting_of(std::make_shared<const VoxelField>(grid, VoxelFieldOptions{}),
                               usual_transfer(summary, *grid), summary.least, summary.greatest));
}

Picture picture_of_head(int size)
{
    Picture picture;
    const float end = static_cast<float>(size - 1);
    picture.volumes = {{.data = casting_of_head(size),
                        .to_world = glm::scale(glm::dmat4(1), glm::dvec3(2.0 / size)),
                        .high = glm::vec3(end)}};
    picture.camera.target = glm::dvec3(1);
    picture.camera.eye = {3.4, -4, 2.6};
    return picture;
}

void draw_often(benchmark::State& state, const Picture& picture, bool on_card = false)
{
    const HeadlessContext context;
    Renderer renderer;
    renderer.cast_on_card(on_card);
    renderer.draw(picture, {1280, 720});
    glFinish();
    for (auto _ : state) {
        renderer.draw(picture, {1280, 720});
        glFinish();
    }
    state.SetLabel(describe_context());
    for (const auto& stage : renderer.timings().stages)
        state.counters[stage.name + " ms"] = stage.time_ms;
}

// Draws a window of 1280 x 720 as while the view moves, at a share of its size in percent.
void cast_draft(benchmark::State& state)
{
    Picture picture = picture_of_head(static_cast<int>(state.range(0)));
    picture.draft = true;
    picture.scale = static_cast<double>(state.range(1)) / 100;
    draw_often(state, picture);
}

// The same at rest: four samples, or one.
void cast_full(benchmark::State& state)
{
    Picture picture = picture_of_head(static_cast<int>(state.range(0)));
    picture.samples = static_cast<int>(state.range(1));
    draw_often(state, picture);
}

// The baseline: the same by the shaders of software GL.
void cast_baseline_shaders(benchmark::State& state)
{
    Picture picture = picture_of_head(static_cast<int>(state.range(0)));
    picture.samples = 1;
    draw_often(state, picture, true);
}

// Measures the cost of a new transfer function before a picture.
void cast_transfer(benchmark::State& state)
{
    const Ref<Casting> head = casting_of_head(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(casting_of(
            head->field, std::vector<TransferPoint>{{500, {1, 1, 1}, 0}, {900, {1, 1, 1}, 1}},
            head->transfer.least, head->transfer.greatest));
}

BENCHMARK(cast_draft)->Args({256, 85})->Args({256, 50})->Unit(benchmark::kMillisecond);
BENCHMARK(cast_full)->Args({256, 1})->Args({256, 4})->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK(cast_baseline_shaders)->Arg(256)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(cast_transfer)->Arg(256)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar::gpu
