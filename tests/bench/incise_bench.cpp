// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/primitives.h"
#include "core/document/asset_store.h"
#include "core/evaluation/evaluate.h"
#include "core/incise/incise.h"
#include "core/incise/opened_frames.h"
#include "core/mesh/primitives.h"

#include <benchmark/benchmark.h>
#include <map>
#include <numbers>

// Cuts in a torus: of 10^4, 10^5 and 10^6 triangles with a cut of as many edges in each, and large
// ones in that of 10^6. The copy of the mesh, which is part of the whole, is measured beside it.
namespace trivar {
namespace {

// A torus of 2 n n triangles, a point a vertex.
const SlitSkin& torus_skin(int n)
{
    static std::map<int, SlitSkin> skins;
    const auto known = skins.find(n);
    if (known != skins.end()) return known->second;
    const Mesh quads = torus_mesh(1, 0.4, {n, n});
    Mesh out;
    out.positions.resize(point_count(quads));
    for (std::uint32_t v = 0; v < quads.vertex_count(); ++v)
        out.positions[quads.point(v)] = quads.positions[v];
    for (const glm::uvec3& t : triangles(quads))
        add_face(out, std::array{quads.point(t.x), quads.point(t.y), quads.point(t.z)});
    out.normals = smooth_normals(out);
    return skins.emplace(n, SlitSkin(std::make_shared<const RayMesh>(make_ref(std::move(out)))))
        .first->second;
}

// On top of the torus, of a length in its main direction and from an angle on.
Incision cut_along(double length, double from, double slant)
{
    Incision cut;
    constexpr int samples = 60;
    for (int i = 0; i <= samples; ++i) {
        const double t = length * i / samples - length / 2;
        const double u = from + t, v = std::numbers::pi / 2 + slant * t;
        const glm::dvec3 out(std::cos(u), std::sin(u), 0);
        const glm::dvec3 normal = std::cos(v) * out + std::sin(v) * glm::dvec3(0, 0, 1);
        cut.stroke.push_back({out + 0.4 * normal, normal});
    }
    return cut;
}

std::vector<Incision> small_cut(const SlitSkin& skin)
{
    const double edge = skin.usual_edge();
    Incision cut = cut_along(20 * edge, 0.3, 0.4);
    cut.depth = 2 * edge;
    cut.width = 2 * edge;
    return {cut};
}

std::vector<Incision> large_cuts(int count, double length, double width)
{
    std::vector<Incision> cuts;
    for (int k = 0; k < count; ++k) {
        cuts.push_back(cut_along(length, 0.3, k % 2 == 0 ? 0.5 : -0.5));
        cuts.back().depth = 0.05;
        cuts.back().width = width;
    }
    return cuts;
}

void incise_cuts(benchmark::State& state, const SlitSkin& skin, const std::vector<Incision>& cuts,
                 bool guarded)
{
    RefPool<Mesh> meshes; // as while a cut is changed, frame by frame
    IncisedMesh made;
    for (auto _ : state) made = incise(skin, cuts, {.guarded = guarded}, meshes);
    state.counters["triangles"] = static_cast<double>(skin.triangle_count());
    state.counters["terms"] = static_cast<double>(made.terms.size());
    state.counters["widest"] = made.outcomes[0].widest; // share of the width that the guard admits
    state.counters["walls"] = static_cast<double>(made.rest->face_count() - made.first_wall_face);
}

void BM_incise_topology(benchmark::State& state) // and the copy
{
    const SlitSkin& skin = torus_skin(static_cast<int>(state.range(0)));
    std::vector<Incision> cuts = small_cut(skin);
    cuts[0].width = 0;
    incise_cuts(state, skin, cuts, false);
}
void BM_incise_whole(benchmark::State& state)
{
    const SlitSkin& skin = torus_skin(static_cast<int>(state.range(0)));
    incise_cuts(state, skin, small_cut(skin), state.range(1) != 0);
}
void BM_incise_copy(benchmark::State& state)
{
    const SlitSkin& skin = torus_skin(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(Mesh(*skin.mesh()));
}
void BM_incise_opening(benchmark::State& state)
{
    const SlitSkin& skin = torus_skin(static_cast<int>(state.range(0)));
    const IncisedMesh made = incise(skin, small_cut(skin));
    const std::vector<IncisionOpening> half(1, IncisionOpening{0.5, 0, 1});
    for (auto _ : state) benchmark::DoNotOptimize(opened_vertices(made, half));
}
// The whole mesh at openings one after the other, of which the last few are held.
void BM_incise_frame(benchmark::State& state)
{
    const SlitSkin& skin = torus_skin(static_cast<int>(state.range(0)));
    const OpenedFrames frames(make_ref(incise(skin, small_cut(skin))));
    std::array<OpenedFrames::Frame, 3> held;
    std::size_t number = 0;
    const auto show = [&] {
        const double share = 0.2 + 0.001 * static_cast<double>(number % 700);
        held[number++ % held.size()] = frames(std::vector{IncisionOpening{share, 0, 1}});
    };
    for (int i = 0; i < 8; ++i) show();
    for (auto _ : state) show();
}
// The same in a document: a ball of as many triangles with a cut whose opening has keys.
void BM_incise_document_frame(benchmark::State& state)
{
    const auto n = static_cast<int>(state.range(0));
    NamedIncision incision;
    for (int i = 0; i <= 60; ++i) {
        const double t = 63.0 / n * (i / 30.0 - 1); // 20 edges in all
        const glm::dvec3 p = glm::normalize(glm::dvec3(1, t, 0.1));
        incision.cut.stroke.push_back({p, p});
    }
    incision.cut.depth = incision.cut.width = 12.5 / n;
    Document document = after({}, AddSphere{.shape = {.radius = 1, .segments = n, .rings = n}});
    document = after(document, Incise{1, incision});
    document =
        after(document, Animate{{{1, {{"incising.cuts.0.opening", {{1, 0.1}, {1001, 1}}}}}}});
    Evaluator evaluate(std::make_shared<const AssetStore>(""));
    double frame = 1;
    Ref<Mesh> last;
    const auto show = [&] {
        frame = frame < 1000 ? frame + 1 : 1;
        const Evaluation evaluated = evaluate(document, frame);
        const Ref<Mesh>& mesh = evaluated.objects.at(1)->parts.at(0).mesh();
        if (mesh == last) state.SkipWithError("nothing moves");
        last = mesh;
    };
    for (int i = 0; i < 12; ++i) show();
    for (auto _ : state) show();
}
// Cuts 10^6 triangles: number of cuts that cross, thousandths of length and of width.
void BM_incise_large(benchmark::State& state)
{
    const double width = 1e-3 * static_cast<double>(state.range(2));
    incise_cuts(state, torus_skin(707),
                large_cuts(static_cast<int>(state.range(0)),
                           1e-3 * static_cast<double>(state.range(1)), width),
                state.range(3) != 0);
}
void BM_incise_large_opening(benchmark::State& state)
{
    const std::vector<Incision> cuts =
        large_cuts(static_cast<int>(state.range(0)), 1e-3 * static_cast<double>(state.range(1)),
                   1e-3 * static_cast<double>(state.range(2)));
    const IncisedMesh made = incise(torus_skin(707), cuts, {.guarded = false});
    const std::vector<IncisionOpening> half(cuts.size(), IncisionOpening{0.5, 0, 1});
    for (auto _ : state) benchmark::DoNotOptimize(opened_vertices(made, half));
    state.counters["terms"] = static_cast<double>(made.terms.size());
}

BENCHMARK(BM_incise_topology)->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_copy)->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_whole)->ArgsProduct({{71, 224, 707}, {0, 1}})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_opening)->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_frame)->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_document_frame)->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_large)
    ->Args({1, 450, 15, 0})
    ->Args({1, 450, 40, 0})
    ->Args({2, 450, 40, 0})
    ->Args({1, 450, 40, 1})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_incise_large_opening)
    ->Args({1, 450, 15})
    ->Args({1, 450, 40})
    ->Args({2, 450, 40})
    ->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace trivar
