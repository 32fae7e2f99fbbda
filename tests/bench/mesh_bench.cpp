// SPDX-License-Identifier: GPL-3.0-or-later
// What asks for the edges of a mesh of half a million triangles.
#include "core/base/parallel.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "core/mesh/repair.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

// 1000 x 250 quads cut to triangles.
Mesh half_a_million()
{
    Mesh torus = torus_mesh(2, 0.7, {1000, 250});
    const std::vector<glm::uvec3> cut = triangles(torus);
    torus.corners.clear();
    torus.face_begin = {0};
    for (const glm::uvec3& t : cut) add_face(torus, std::array{t.x, t.y, t.z});
    return torus;
}

void edges_adjacency(benchmark::State& state)
{
    const Mesh mesh = half_a_million();
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(Adjacency(mesh));
}
BENCHMARK(edges_adjacency)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void edges_is_closed_body(benchmark::State& state)
{
    const Mesh mesh = half_a_million();
    for (auto _ : state) benchmark::DoNotOptimize(is_closed_body(mesh));
}
BENCHMARK(edges_is_closed_body)->Unit(benchmark::kMillisecond)->UseRealTime();

void edges_repaired(benchmark::State& state)
{
    const Mesh mesh = half_a_million();
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(repaired(mesh));
}
BENCHMARK(edges_repaired)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace trivar
