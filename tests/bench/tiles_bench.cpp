// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/tiles/bent_tiles.h"
#include "core/tiles/chart.h"
#include "core/tiles/fold_limit.h"

#include <benchmark/benchmark.h>

// About 10,000 tiles that fill a torus of 20,000 triangles, and what each part of their evaluation
// takes: places, charts, patches with their guard where the torus has moved, and bent vertices.
namespace trivar {
namespace {

constexpr double tile_size = 0.03;

struct TiledTorus {
    TileBase base;
    std::vector<Ref<TileStroke>> strokes;
    TileLayout layout;
    std::vector<TileChart> charts;
    BasePose pose;

    TiledTorus() : base({{std::make_shared<const RayMesh>(make_ref(welded())), glm::dmat4(1)}})
    {
        TileStroke stroke;
        stroke.brush = TileBrush::fill;
        stroke.size = tile_size;
        stroke.samples = {{{{1.4, 0, 0}, {1, 0, 0}}}};
        strokes = {make_ref(stroke)};
        layout = layout_of(base, strokes);
        for (const Tile& tile : layout.tiles) charts.push_back(chart_of(base, tile, 0, 1));
        std::vector<glm::uvec3> triangles;
        for (std::uint32_t t = 0; t < base.triangle_count(); ++t)
            triangles.push_back(base.triangle(t));
        pose = {base.points(), angle_normals(base.points(), triangles)};
    }
    static Mesh welded()
    {
        Mesh mesh = torus_mesh(1, 0.4, {144, 72});
        if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
        return mesh;
    }
};

const TiledTorus& tiled_torus()
{
    static const TiledTorus all;
    return all;
}

void per_tile(benchmark::State& state)
{
    state.counters["tiles"] = static_cast<double>(tiled_torus().layout.tiles.size());
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(tiled_torus().layout.tiles.size()));
}

void tiles_layout(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(layout_of(tiled_torus().base, tiled_torus().strokes));
    per_tile(state);
}

void tiles_charts(benchmark::State& state)
{
    for (auto _ : state)
        for (const Tile& tile : tiled_torus().layout.tiles)
            benchmark::DoNotOptimize(chart_of(tiled_torus().base, tile, 0, 1));
    per_tile(state);
}

void tiles_patches(benchmark::State& state)
{
    const TiledTorus& all = tiled_torus();
    for (auto _ : state)
        for (const TileChart& chart : all.charts)
            benchmark::DoNotOptimize(patch_of(all.base, all.pose, chart));
    per_tile(state);
}

void tiles_guard(benchmark::State& state)
{
    const TiledTorus& all = tiled_torus();
    std::vector<TilePatch> patches;
    for (const TileChart& chart : all.charts)
        patches.push_back(patch_of(all.base, all.pose, chart));
    for (auto _ : state)
        for (const TilePatch& patch : patches) benchmark::DoNotOptimize(fold_limit(patch));
    per_tile(state);
}

void tiles_bent(benchmark::State& state)
{
    const TiledTorus& all = tiled_torus();
    std::vector<PlacedTile> placed;
    for (const TileChart& chart : all.charts)
        placed.push_back({patch_of(all.base, all.pose, chart), tile_size, 0});
    const Mesh stud = sphere_mesh(0.5, 16, 8);
    for (auto _ : state)
        benchmark::DoNotOptimize(bent_tiles(stud, glm::dmat4(1), {{0, 0, -0.5}, 1, 1}, placed));
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(placed.size() * stud.vertex_count()));
}

BENCHMARK(tiles_layout)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_charts)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_patches)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_guard)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_bent)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
