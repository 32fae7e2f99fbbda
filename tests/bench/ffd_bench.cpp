// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/ffd/deform.h"

#include <benchmark/benchmark.h>
#include <random>

namespace trivar {
namespace {

Mesh random_points(std::size_t count, bool normals)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> in(0, 1);
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.emplace_back(in(random), in(random), in(random));
        if (normals)
            mesh.normals.push_back(
                glm::normalize(glm::vec3(in(random)-0.5f, in(random)-0.5f, in(random)-0.5f)));
    }
    return mesh;
}

Lattice random_lattice(int order, int count)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(-0.02, 0.02);
    const Knots knots = Knots::uniform(order, count);
    Lattice lattice = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    for (glm::dvec3& d : lattice.displacement.points) d = {in(random), in(random), in(random)};
    return lattice;
}

// What one writes first: vertex after vertex, span, basis functions, triple sum. Single precision,
// the order known to the compiler, the span found by a multiplication.
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

    template <bool with_normals> void run(const Mesh& mesh, Deformed& out) const
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

// Two workloads: 2^20 random points in a 12^3 lattice, 10^6 in one of 8^3.
std::size_t points_for(int lattice)
{
    return lattice == 12 ? std::size_t{1} << 20 : 1000000;
}

template <int order, bool normals> void ffd_plain_loop(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(0));
    const Mesh mesh = random_points(points_for(size), normals);
    const PlainLoop<order> loop(random_lattice(order, size));
    Deformed out{mesh.positions, mesh.normals, {}};
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
    const int size = static_cast<int>(state.range(0));
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const Mesh mesh = random_points(points_for(size), normals);
    const Lattice lattice = random_lattice(order, size);
    const Deformer deformer(make_ref(mesh), {}, lattice.displacement.axes);
    Deformed out = deformer.arrays(lattice);
    for (auto _ : state) {
        out = deformer.arrays(lattice, std::move(out));
        benchmark::DoNotOptimize(out.positions.data());
        benchmark::ClobberMemory();
    }
    count_points(state, mesh.vertex_count());
}

void ffd_sorting(benchmark::State& state)
{
    const int size = static_cast<int>(state.range(0));
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const Ref<Mesh> mesh = make_ref(random_points(points_for(size), true));
    const Lattice lattice = random_lattice(4, size);
    for (auto _ : state) {
        const Deformer deformer(mesh, {}, lattice.displacement.axes);
        benchmark::DoNotOptimize(&deformer);
    }
    count_points(state, mesh->vertex_count());
}

#define FFD_BENCHMARKS(order, normals)                                                       \
    BENCHMARK_TEMPLATE(ffd_plain_loop, order, normals)->ArgName("lattice")->Arg(12)->Arg(8); \
    BENCHMARK_TEMPLATE(ffd_deformer, order, normals)                                         \
        ->ArgNames({"lattice", "threads"})                                                   \
        ->ArgsProduct({{12, 8}, {1, 2}})                                                     \
        ->UseRealTime()

FFD_BENCHMARKS(3, false);
FFD_BENCHMARKS(4, false);
FFD_BENCHMARKS(3, true);
FFD_BENCHMARKS(4, true);
BENCHMARK(ffd_sorting)
    ->ArgNames({"lattice", "threads"})
    ->ArgsProduct({{12, 8}, {1, 2}})
    ->UseRealTime();

} // namespace
} // namespace trivar
