// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/deform.h"
#include "core/mesh/primitives.h"
#include "core/placement/box_volume.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_rows.h"
#include "core/tetrahedra/fold_guard.h"
#include "core/tetrahedra/tetrahedra_layers.h"

#include <benchmark/benchmark.h>
#include <cmath>

namespace trivar {
namespace {

Ref<SimplexBasis<3>> box_basis(int degree, int boxes)
{
    const SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(boxes));
    return make_ref(SimplexBasis<3>(with_clouds<3>(mesh.vertices, mesh.cells, degree)));
}

// Points on a ball of radius 0.95, in rows.
std::vector<glm::vec3> ball_points(std::size_t count)
{
    std::vector<glm::vec3> out;
    const auto around = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
    for (std::size_t i = 0; i < count; ++i) {
        const double a =
            6.283185307179586 * static_cast<double>(i % around) / static_cast<double>(around);
        const double z = 1.9 * static_cast<double>(i) / static_cast<double>(count) - 0.95;
        const double r = std::sqrt(std::max(0.0, 0.9025 - z * z));
        out.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
    return out;
}

std::vector<glm::dvec3> some_displacements(std::size_t count)
{
    std::vector<glm::dvec3> out;
    for (std::size_t i = 0; i < count; ++i)
        out.emplace_back(0.05 * std::sin(static_cast<double>(i)), 0.02, -0.03);
    return out;
}

void simplex_bind(benchmark::State& state)
{
    const std::vector<Ref<SimplexBasis<3>>> layers{box_basis(static_cast<int>(state.range(1)), 4)};
    const std::vector<glm::vec3> points = ball_points(static_cast<std::size_t>(state.range(0)));
    std::size_t bytes = 0;
    for (auto _ : state) bytes = SimplexRows(layers, points, false).bytes();
    state.counters["bytes_per_point"] =
        static_cast<double>(bytes) / static_cast<double>(points.size());
}
BENCHMARK(simplex_bind)
    ->ArgNames({"points", "degree"})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->Args({100000, 3})
    ->Args({1000000, 2})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void simplex_edit(benchmark::State& state)
{
    const std::vector<Ref<SimplexBasis<3>>> layers{box_basis(static_cast<int>(state.range(1)), 4)};
    const bool normals = state.range(2) != 0;
    const SimplexRows rows(layers, ball_points(static_cast<std::size_t>(state.range(0))), normals);
    const std::vector<glm::dvec3> by = some_displacements(layers[0]->point_count());
    DisplacedPoints out;
    for (auto _ : state) {
        out = rows.displaced(by, std::move(out));
        benchmark::DoNotOptimize(out.positions.data());
    }
    state.counters["bytes_per_point"] =
        static_cast<double>(rows.bytes()) / static_cast<double>(rows.point_count());
}
BENCHMARK(simplex_edit)
    ->ArgNames({"points", "degree", "normals"})
    ->Args({1000000, 2, 0})
    ->Args({250000, 2, 1})
    ->Args({1000000, 3, 0})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void simplex_guard(benchmark::State& state)
{
    const std::vector<Ref<SimplexBasis<3>>> layers{box_basis(2, static_cast<int>(state.range(0)))};
    const FoldGuard guard(layers);
    const std::vector<glm::dvec3> rest(layers[0]->point_count(), glm::dvec3(0)),
        change = some_displacements(layers[0]->point_count());
    for (auto _ : state) benchmark::DoNotOptimize(guard.allowed(rest, change));
    state.counters["samples"] = static_cast<double>(guard.sample_count());
}
BENCHMARK(simplex_guard)->ArgName("boxes")->Arg(4)->Arg(12)->Unit(benchmark::kMillisecond);

// A dent that is small beside its volume, as of one finger of a hand: its greatest error, in shares
// of its depth, with control points that stand at its values where they rest.
constexpr double dent_radius = 0.25;
double dent(const glm::dvec3& p)
{
    return decay(Decay::smooth, glm::distance(p, glm::dvec3(0.3, 0.2, 0.1)) / dent_radius);
}

std::vector<glm::vec3> dent_points()
{
    std::vector<glm::vec3> out;
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j)
            out.emplace_back(0.3 + 0.6 * (i / 40.0 - 0.5), 0.2 + 0.6 * (j / 40.0 - 0.5), 0.1);
    return out;
}

void simplex_local(benchmark::State& state)
{
    TetrahedraShape shape{.size = glm::dvec3(2)};
    shape.edits = {
        {.refinement = TetrahedraRefinement{
             {{0.3, 0.2, 0.1}}, 1.35 * dent_radius, static_cast<double>(state.range(0)) / 1000}}};
    const std::vector<Ref<SimplexBasis<3>>> layers = layers_of(shape);
    std::vector<glm::dvec3> by(layers[0]->point_count(), glm::dvec3(0));
    for (const glm::dvec3& rest : layers[1]->rest()) by.emplace_back(dent(rest), 0, 0);
    const std::vector<glm::vec3> points = dent_points();
    const SimplexRows rows(layers, points, false);
    DisplacedPoints out;
    for (auto _ : state) out = rows.displaced(by, std::move(out));
    double error = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        error = std::max(error, std::abs(static_cast<double>(out.positions[i].x - points[i].x) -
                                         dent(points[i])));
    state.counters["control_points"] = static_cast<double>(by.size());
    state.counters["error"] = error;
}
BENCHMARK(simplex_local)
    ->ArgName("edge_mm")
    ->Arg(120)
    ->Arg(80)
    ->Arg(50)
    ->Unit(benchmark::kMicrosecond);

void simplex_local_tensor(benchmark::State& state) // the same by a lattice, fine along whole planes
{
    const auto n = static_cast<int>(state.range(0));
    Placement box = place_box(glm::dvec3(2), glm::ivec3(n), glm::ivec3(3));
    std::vector<PointMove> moves;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                moves.push_back({{i, j, k}, {dent(control_point(box.volume, i, j, k)), 0, 0}});
    const Lattice lattice = moved(box.volume, moves);
    Mesh mesh;
    mesh.positions = dent_points();
    const Deformer deformer(make_ref(Mesh(mesh)), {box.embedding.to_uvw, glm::dmat4(1)},
                            lattice.displacement.axes);
    DeformedArrays out;
    for (auto _ : state) out = deformer.arrays(lattice, std::move(out));
    double error = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        error =
            std::max(error, std::abs(static_cast<double>(out.positions[i].x - mesh.positions[i].x) -
                                     dent(mesh.positions[i])));
    state.counters["control_points"] = static_cast<double>(moves.size());
    state.counters["error"] = error;
}
BENCHMARK(simplex_local_tensor)
    ->ArgName("points")
    ->Arg(18)
    ->Arg(26)
    ->Arg(42)
    ->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace trivar
