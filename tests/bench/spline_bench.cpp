// SPDX-License-Identifier: GPL-3.0-or-later
// The baseline in the same file: the sum of products written as in the definition.
#include "core/spline/fit.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <random>

namespace trivar {
namespace {

Trivariate<glm::dvec3> shaken(int order, glm::ivec3 counts)
{
    std::mt19937 random(1);
    const auto noise = [&] { return 0.02 * static_cast<double>(random()) / 4294967296.0; };
    Trivariate<glm::dvec3> f{{Knots::uniform(order, counts.x), Knots::uniform(order, counts.y),
                              Knots::uniform(order, counts.z)},
                             {}};
    for (int i = 0; i < counts.x; ++i)
        for (int j = 0; j < counts.y; ++j)
            for (int k = 0; k < counts.z; ++k) {
                const double turn = 3 * f.axes[0].greville(i), r = 1 + 0.5 * f.axes[2].greville(k);
                f.points.push_back({r * std::cos(turn) + noise(), f.axes[1].greville(j) + noise(),
                                    r * std::sin(turn) + noise()});
            }
    return f;
}

std::vector<glm::dvec3> parameters(std::size_t count)
{
    std::mt19937 random(2);
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<glm::dvec3> out;
    for (std::size_t i = 0; i < count; ++i) out.emplace_back(share(), share(), share());
    return out;
}

glm::dvec3 by_definition(const Trivariate<glm::dvec3>& f, glm::dvec3 uvw)
{
    const Basis a = basis(f.axes[0], uvw.x), b = basis(f.axes[1], uvw.y),
                c = basis(f.axes[2], uvw.z);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.axes[0].order()); ++i)
        for (std::size_t j = 0; j < static_cast<std::size_t>(f.axes[1].order()); ++j)
            for (std::size_t k = 0; k < static_cast<std::size_t>(f.axes[2].order()); ++k)
                sum += a.value[i] * b.value[j] * c.value[k] *
                       f.point(a.first + static_cast<int>(i), b.first + static_cast<int>(j),
                               c.first + static_cast<int>(k));
    return sum;
}

void evaluate_by_definition(benchmark::State& state)
{
    const auto f = shaken(static_cast<int>(state.range(0)), {33, 9, 6});
    const auto at = parameters(1024);
    for (auto _ : state)
        for (const glm::dvec3& p : at) benchmark::DoNotOptimize(by_definition(f, p));
    state.SetItemsProcessed(state.iterations() * 1024);
}
BENCHMARK(evaluate_by_definition)->Arg(3)->Arg(4)->Arg(6);

void evaluate_value(benchmark::State& state)
{
    const auto f = shaken(static_cast<int>(state.range(0)), {33, 9, 6});
    const auto at = parameters(1024);
    for (auto _ : state)
        for (const glm::dvec3& p : at) benchmark::DoNotOptimize(evaluate(f, p));
    state.SetItemsProcessed(state.iterations() * 1024);
}
BENCHMARK(evaluate_value)->Arg(3)->Arg(4)->Arg(6);

void evaluate_second_derivatives(benchmark::State& state)
{
    const auto f = shaken(static_cast<int>(state.range(0)), {33, 9, 6});
    const auto at = parameters(1024);
    for (auto _ : state)
        for (const glm::dvec3& p : at) benchmark::DoNotOptimize(evaluate(f, p, 2));
    state.SetItemsProcessed(state.iterations() * 1024);
}
BENCHMARK(evaluate_second_derivatives)->Arg(3)->Arg(4)->Arg(6);

void interpolate_surface(benchmark::State& state)
{
    const std::array<Knots, 2> axes{Knots::uniform(4, 64), Knots::uniform(4, 32)};
    std::vector<glm::dvec3> values;
    for (const glm::dvec3& p : parameters(64 * 32)) values.push_back(p);
    for (auto _ : state) benchmark::DoNotOptimize(interpolate(axes, values));
}
BENCHMARK(interpolate_surface)->Unit(benchmark::kMillisecond);

void fit_curve(benchmark::State& state)
{
    const Knots knots = Knots::uniform(4, static_cast<int>(state.range(0)));
    std::vector<glm::dvec2> values;
    std::vector<double> t;
    for (const glm::dvec3& p : parameters(2000)) {
        values.emplace_back(p.x, p.y);
        t.push_back(static_cast<double>(t.size()) / 1999);
    }
    for (auto _ : state) benchmark::DoNotOptimize(fit(knots, t, values, {.ends = true}));
}
BENCHMARK(fit_curve)->Arg(12)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
