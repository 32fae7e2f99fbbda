// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/primitives.h"
#include "core/split/cap.h"
#include "core/split/split.h"

#include <benchmark/benchmark.h>

// A torus of 500,000 triangles that planes cut in two closed halves (the workload W2 of the other
// programs: two discs, one ring, and a plane through two rings of vertices), and models that are
// parted by a bar.
namespace trivar {
namespace {

const Mesh& torus_of_triangles()
{
    static const Mesh torus = [] {
        const Mesh quads = torus_mesh(1, 0.4, {500, 500});
        Mesh out = quads;
        // The workload has positions and faces alone, a point a vertex.
        out.normals.clear();
        out.uvs.clear();
        out.points.clear();
        out.positions.assign(point_count(quads), {});
        for (std::uint32_t v = 0; v < quads.vertex_count(); ++v)
            out.positions[quads.point(v)] = quads.positions[v];
        out.corners.clear();
        out.face_begin = {0};
        for (const glm::uvec3& t : triangles(quads))
            add_face(out, std::array{quads.point(t.x), quads.point(t.y), quads.point(t.z)});
        return out;
    }();
    return torus;
}

struct CutPlane {
    glm::dvec3 normal;
    double offset;
};

void split_torus(benchmark::State& state, CutPlane plane, double step)
{
    const Mesh& torus = torus_of_triangles();
    const glm::dvec3 n = glm::normalize(plane.normal);
    const glm::dvec3 x = glm::normalize(glm::cross(n, glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(n, x);
    std::vector<double> heights(torus.vertex_count());
    double offset = plane.offset / glm::length(plane.normal);
    std::size_t rim = 0, fans = 0;
    CutMesh last;
    for (auto _ : state) {
        offset += step;
        parallel_blocks(heights.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                heights[v] = glm::dot(n, glm::dvec3(torus.positions[v])) - offset;
        });
        // While a plane moves, the memory of its last place is used again
        CutMesh halves = cut(torus, heights, step != 0 ? std::move(last) : CutMesh{});
        CapOptions options;
        for (const glm::vec3& p : halves.places)
            options.places.emplace_back(glm::dot(x, glm::dvec3(p)), glm::dot(y, glm::dvec3(p)));
        options.point = [&](const glm::dvec2& at) { return offset * n + at.x * x + at.y * y; };
        options.normal = [&](const glm::dvec2&) { return n; };
        fans = cap(halves, options).fans;
        rim = halves.rim.size();
        if (step != 0) last = std::move(halves);
    }
    state.counters["rim"] = static_cast<double>(rim);
    state.counters["fans"] = static_cast<double>(fans);
}

// A ball round which a bar passes, per frame; `segments` round it.
void split_ball(benchmark::State& state, int segments)
{
    Mesh bar = cylinder_mesh(0.18, 4, 64, 8);
    SplitObstacle obstacle{"bar", {{std::make_shared<const RayMesh>(make_ref(bar))}}};
    const SplitField field = split_field({obstacle}, {});
    const Mesh ball = sphere_mesh(0.9, segments, segments / 2);
    double at = -0.9;
    std::size_t vertices = 0, fans = 0;
    Mesh moved;
    SplitMemory memory;
    for (auto _ : state) {
        state.PauseTiming();
        moved = ball;
        for (glm::vec3& p : moved.positions) p.y += static_cast<float>(at);
        at = at > 0.9 ? -0.9 : at + 0.1;
        state.ResumeTiming();
        std::optional<SplitMesh> parted = split(moved, field, {}, memory);
        vertices = parted ? parted->mesh.vertex_count() : 0;
        fans += parted ? parted->fans : 0;
        if (parted) memory.mesh = std::move(parted->mesh);
    }
    state.counters["vertices"] = static_cast<double>(vertices);
    state.counters["fans"] = static_cast<double>(fans);
}

void split_field_of_a_bar(benchmark::State& state)
{
    Mesh bar = cylinder_mesh(0.18, 4, 64, 8);
    SplitObstacle obstacle{"bar", {{std::make_shared<const RayMesh>(make_ref(bar))}}};
    for (auto _ : state) benchmark::DoNotOptimize(split_field({obstacle}, {}));
}

BENCHMARK_CAPTURE(split_torus, two_discs, CutPlane{{1, 0.2, 0.1}, 0.05}, 0.0)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_torus, ring, CutPlane{{0.15, 0.1, 1}, 0.03}, 0.0)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_torus, through_vertices, CutPlane{{0, 0, 1}, 0}, 0.0)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_torus, two_discs_moving, CutPlane{{1, 0.2, 0.1}, 0.05}, 1e-5)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_torus, ring_moving, CutPlane{{0.15, 0.1, 1}, 0.03}, 1e-5)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_torus, through_vertices_moving, CutPlane{{0, 0, 1}, 0}, 1e-300)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_ball, vertices_32000, 256)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split_ball, vertices_10_6, 1414)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(split_field_of_a_bar)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
