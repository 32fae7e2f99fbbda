// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/deform.h"
#include "core/mesh/primitives.h"
#include "tests/support/splines.h"

#include <benchmark/benchmark.h>

namespace trivar {
namespace {

Mesh random_points(std::size_t count)
{
    testing::Noise noise;
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.emplace_back(noise.vec3() * 0.5 + 0.5);
        mesh.normals.emplace_back(glm::normalize(noise.vec3()));
    }
    return mesh;
}

// In the box [0, 1]^3, its vertices in rows, as models have them.
Mesh sphere()
{
    Mesh mesh = sphere_mesh(0.49, 1024, 1000);
    for (glm::vec3& p : mesh.positions) p += 0.5f;
    return mesh;
}

// Two of random points, the worst case, for a lattice of 12^3 and one of 8^3; the sphere for both.
Mesh model(int lattice, bool on_sphere, bool normals)
{
    Mesh mesh = on_sphere       ? sphere()
                : lattice == 12 ? random_points(std::size_t{1} << 20)
                                : random_points(1000000);
    if (!normals) mesh.normals.clear();
    mesh.tangents.clear();
    return mesh;
}

Lattice random_lattice(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    return {testing::random_volume({knots, knots, knots}, 2, 0.02), glm::dmat4(1)};
}

// PlainLoop is the first version that one would write: vertex after vertex, span, basis functions,
// triple sum. Single precision, the order known to the compiler, the span found by a
// multiplication.
template <int order> struct PlainLoop {
    int count;
    std::vector<float> knots;
    std::vector<glm::vec3> points;

    explicit PlainLoop(const Lattice& lattice) : count(lattice.displacement.axes[0].count())
    {
        for (const double k : lattice.displacement.axes[0].values())
            knots.push_back(static_cast<float>(k));
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j)
                for (int k = 0; k < count; ++k)
                    points.emplace_back(control_point(lattice, i, j, k));
    }

    struct Basis {
        int first;
        float value[order], slope[order];
    };

    template <bool slopes> Basis basis(float u) const
    {
        Basis b;
        const int spans = count - order + 1;
        b.first = std::min(static_cast<int>(u * static_cast<float>(spans)), spans - 1);
        const float* t = knots.data() + b.first + order - 1;
        float left[order], right[order], lower[order];
        b.value[0] = 1;
        for (int p = 1; p < order; ++p) {
            if (slopes && p == order - 1) std::copy_n(b.value, p, lower);
            left[p] = u - t[1 - p];
            right[p] = t[p] - u;
            float saved = 0;
            for (int r = 0; r < p; ++r) {
                const float share = b.value[r] / (right[r + 1] + left[p - r]);
                b.value[r] = saved + right[r + 1] * share;
                saved = left[p - r] * share;
            }
            b.value[p] = saved;
        }
        if (!slopes) return b;
        const int d = order - 1;
        float before = 0;
        for (int r = 0; r < order; ++r) {
            const float after =
                r < d ? static_cast<float>(d) * lower[r] / (t[r + 1] - t[r + 1 - d]) : 0;
            b.slope[r] = before - after;
            before = after;
        }
        return b;
    }

    template <bool with_normals> void run(const Mesh& mesh, DeformedArrays& out) const
    {
        for (std::size_t q = 0; q < mesh.positions.size(); ++q) {
            const glm::vec3 p = mesh.positions[q];
            const Basis u = basis<with_normals>(p.x), v = basis<with_normals>(p.y),
                        w = basis<with_normals>(p.z);
            glm::vec3 f(0), fu(0), fv(0), fw(0);
            for (int i = 0; i < order; ++i)
                for (int j = 0; j < order; ++j)
                    for (int k = 0; k < order; ++k) {
                        const glm::vec3& c = points[static_cast<std::size_t>(
                            ((u.first + i) * count + v.first + j) * count + w.first + k)];
                        f += u.value[i] * v.value[j] * w.value[k] * c;
                        if (!with_normals) continue;
                        fu += u.slope[i] * v.value[j] * w.value[k] * c;
                        fv += u.value[i] * v.slope[j] * w.value[k] * c;
                        fw += u.value[i] * v.value[j] * w.slope[k] * c;
                    }
            out.positions[q] = f;
            if (!with_normals) continue;
            const glm::vec3 n = mesh.normals[q];
            out.normals[q] = glm::normalize(n.x * glm::cross(fv, fw) + n.y * glm::cross(fw, fu) +
                                            n.z * glm::cross(fu, fv));
        }
    }
};

void count_points(benchmark::State& state, std::size_t points)
{
    state.counters["points/s"] = benchmark::Counter(static_cast<double>(points),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}

template <int order, bool normals> void ffd_plain_loop(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(1));
    const Mesh mesh = model(size, state.range(0) != 0, normals);
    const PlainLoop<order> loop(random_lattice(order, size));
    DeformedArrays out{mesh.positions, mesh.normals, {}};
    for (auto _ : state) {
        loop.template run<normals>(mesh, out);
        benchmark::DoNotOptimize(out.positions.data());
        benchmark::ClobberMemory();
    }
    count_points(state, mesh.vertex_count());
}

// Sorting is done before: it belongs to the model and its place in the lattice, not to the edit.
// The conversion of the lattice, which belongs to the edit, is in.
template <int order, bool normals> void ffd_deformer(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(1));
    const ThreadLimit limit(static_cast<int>(state.range(2)));
    const Mesh mesh = model(size, state.range(0) != 0, normals);
    const Lattice lattice = random_lattice(order, size);
    const Deformer deformer(make_ref(mesh), {}, lattice.displacement.axes);
    DeformedArrays out = deformer.arrays(lattice);
    for (auto _ : state) {
        out = deformer.arrays(lattice, std::move(out));
        benchmark::DoNotOptimize(out.positions.data());
        benchmark::ClobberMemory();
    }
    count_points(state, mesh.vertex_count());
}

void ffd_sorting(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(1));
    const ThreadLimit limit(static_cast<int>(state.range(2)));
    const Ref<Mesh> mesh = make_ref(model(size, state.range(0) != 0, true));
    const Lattice lattice = random_lattice(4, size);
    for (auto _ : state) {
        const Deformer deformer(mesh, {}, lattice.displacement.axes);
        benchmark::DoNotOptimize(&deformer);
    }
    count_points(state, mesh->vertex_count());
}

#define FFD_BENCHMARKS(order, normals)                 \
    BENCHMARK_TEMPLATE(ffd_plain_loop, order, normals) \
        ->ArgNames({"sphere", "lattice"})              \
        ->ArgsProduct({{0, 1}, {12, 8}});              \
    BENCHMARK_TEMPLATE(ffd_deformer, order, normals)   \
        ->ArgNames({"sphere", "lattice", "threads"})   \
        ->ArgsProduct({{0, 1}, {12, 8}, {1, 2}})       \
        ->UseRealTime()

FFD_BENCHMARKS(3, false);
FFD_BENCHMARKS(4, false);
FFD_BENCHMARKS(3, true);
FFD_BENCHMARKS(4, true);
BENCHMARK(ffd_sorting)
    ->ArgNames({"sphere", "lattice", "threads"})
    ->ArgsProduct({{0, 1}, {12, 8}, {1, 2}})
    ->UseRealTime();

} // namespace
} // namespace trivar
