// SPDX-License-Identifier: GPL-3.0-or-later
// Bumpy tori of 200,000 and of a million triangles simplified to a tenth, beside OpenMesh's own
// decimation of the same triangles to the same number.
#include "core/mesh/primitives.h"
#include "core/simplify/simplify.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <benchmark/benchmark.h>

namespace trivar {
namespace {

Mesh bumpy_torus(long triangles)
{
    const int tubes = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 5)));
    Mesh mesh = torus_mesh(2, 0.7, {static_cast<int>(triangles / 2 / tubes), tubes});
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.02f * std::sin(9 * p.x) * std::sin(11 * p.y) * std::sin(13 * p.z);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

void count(benchmark::State& state, std::size_t left)
{
    state.counters["left"] = static_cast<double>(left);
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void simplify_to_a_tenth(benchmark::State& state)
{
    const Ref<Mesh> mesh = make_ref(bumpy_torus(state.range(0)));
    const auto after = static_cast<std::size_t>(state.range(0) / 10);
    SimplifiedMesh out;
    for (auto _ : state)
        out = simplified(mesh, {.triangles = after, .error = std::nullopt, .poses = {}});
    count(state, out.triangles);
}
BENCHMARK(simplify_to_a_tenth)->Arg(200'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void simplify_to_an_error(benchmark::State& state)
{
    const Ref<Mesh> mesh = make_ref(bumpy_torus(state.range(0)));
    SimplifiedMesh out;
    for (auto _ : state)
        out = simplified(mesh, {.triangles = std::nullopt, .error = 0.005, .poses = {}});
    count(state, out.triangles);
}
BENCHMARK(simplify_to_an_error)->Arg(200'000)->UseRealTime()->Unit(benchmark::kMillisecond);

void simplify_by_openmesh(benchmark::State& state)
{
    using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;
    const Mesh mesh = bumpy_torus(state.range(0));
    const std::vector<glm::uvec3> cut = triangles(mesh);
    std::size_t left = 0;
    for (auto _ : state) {
        HalfEdges half_edges;
        std::vector<HalfEdges::VertexHandle> made(mesh.vertex_count());
        for (std::uint32_t v = 0; v < made.size(); ++v) {
            HalfEdges::VertexHandle& point = made[mesh.point(v)];
            const glm::vec3& p = mesh.positions[v];
            if (!point.is_valid()) point = half_edges.add_vertex({p.x, p.y, p.z});
        }
        for (const glm::uvec3& t : cut)
            half_edges.add_face(made[mesh.point(t.x)], made[mesh.point(t.y)],
                                made[mesh.point(t.z)]);
        OpenMesh::Decimater::DecimaterT<HalfEdges> decimater(half_edges);
        OpenMesh::Decimater::ModQuadricT<HalfEdges>::Handle handle;
        decimater.add(handle);
        decimater.initialize();
        decimater.decimate_to_faces(0, static_cast<std::size_t>(state.range(0) / 10));
        half_edges.garbage_collection();
        left = half_edges.n_faces();
    }
    count(state, left);
}
BENCHMARK(simplify_by_openmesh)->Arg(200'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
