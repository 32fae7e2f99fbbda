// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/refine.h"
#include "tests/refinement/bent.h"
#include "tests/refinement/truth.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

using namespace testing;

// Triangles of the cube of 12, bent, at 2 % of the volume's diagonal down to 0.5 %.
void refinement_bent_cube(benchmark::State& state)
{
    const Lattice lattice = one_cell(4, bend);
    RefineOptions options{.tolerance_world =
                              0.001 * static_cast<double>(state.range(0)) * diagonal(lattice)};
    const auto count = [&] {
        return static_cast<double>(refine_one(unit_cube(), lattice, options).triangles());
    };
    double ours = 0;
    for (auto _ : state) ours = count();
    options.split = SplitPoint::midpoint;
    state.counters["ours"] = ours;
    state.counters["ours_midpoint"] = count();
    options.rule = RefinementRule::chua_neumann_midpoint;
    state.counters["middles"] = count();
    options.rule = RefinementRule::thesis_four_split;
    options.method = BoundMethod::thesis;
    state.counters["thesis"] = count();
    options.method = BoundMethod::composed_net;
    state.counters["four_split"] = count();
}
BENCHMARK(refinement_bent_cube)->Arg(20)->Arg(10)->Arg(5)->Unit(benchmark::kMillisecond);

// A sphere in a volume of 12 x 8 x 6 points, refined until it has about 10^6 triangles.
void refinement_million(benchmark::State& state)
{
    const Lattice lattice{
        random_volume({Knots::uniform(4, 12), Knots::uniform(4, 8), Knots::uniform(4, 6)}, 5, 0.3),
        glm::dmat4(1)};
    Mesh mesh = sphere_mesh(0.49, 64, 40);
    for (glm::vec3& p : mesh.positions) p += 0.5f;
    RefinementResult out;
    for (auto _ : state) out = refine_one(mesh, lattice, {.tolerance_world = 2.5e-5});
    state.counters["triangles"] = static_cast<double>(out.triangles());
    state.counters["not_certified"] = static_cast<double>(out.not_certified());
    state.counters["bound/tolerance"] = out.bound / 2.5e-5;
}
BENCHMARK(refinement_million)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

// Certified bound by sampled truth, of triangles of the size that refinement ends at.
void refinement_tightness(benchmark::State& state)
{
    const auto method = static_cast<BoundMethod>(state.range(0));
    const Knots knots = Knots::uniform(static_cast<int>(state.range(1)), 10);
    const Trivariate<glm::dvec3> f = random_volume({knots, knots, knots}, 5, 0.05);
    ErrorBounds bounds = bounds_of(f);
    Noise noise(2);
    std::vector<Corners3> all;
    for (int n = 0; n < 1000; ++n) {
        const glm::dvec3 center = noise.vec3() * 0.4 + 0.5;
        all.push_back({center + 0.03 * noise.vec3(), center + 0.03 * noise.vec3(),
                       center + 0.03 * noise.vec3()});
    }
    std::vector<double> of(all.size());
    for (auto _ : state)
        for (std::size_t n = 0; n < all.size(); ++n)
            of[n] = bounds.triangle(corners_of(bounds, all[n]), method);
    for (std::size_t n = 0; n < all.size(); ++n) of[n] /= sampled_error(f, all[n], 24);
    std::sort(of.begin(), of.end());
    state.counters["least"] = of.front();
    state.counters["median"] = of[of.size() / 2];
    state.counters["p95"] = of[of.size() * 95 / 100];
    state.SetItemsProcessed(state.iterations() * static_cast<long>(all.size()));
}
BENCHMARK(refinement_tightness)
    ->ArgsProduct({benchmark::CreateDenseRange(1, 9, 1), {3, 4}})
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
