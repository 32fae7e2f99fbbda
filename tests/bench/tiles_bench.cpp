// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/limit/limit_surface.h"
#include "core/mesh/primitives.h"
#include "core/patches/tile_set.h"
#include "core/tiles/chart.h"
#include "core/tiles/cover_heights.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/layouter.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "gpu/tiles/tile_mirror.h"

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>
#include <hwy/targets.h>

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
    for (auto _ : state) benchmark::DoNotOptimize(fold_limits(patches));
    per_tile(state);
}

Ref<PlacedTiles> placed_tiles()
{
    const TiledTorus& all = tiled_torus();
    std::vector<PlacedTile> out;
    for (const TileChart& chart : all.charts)
        out.push_back({patch_of(all.base, all.pose, chart), tile_size, 0});
    return make_ref(PlacedTiles(std::move(out)));
}

Mesh unit_of(const Mesh& stud)
{
    return in_unit_cell(stud, glm::dmat4(1), {{0, 0, -0.5}, 1, 1});
}

void tiles_hulls(benchmark::State& state)
{
    const Ref<PlacedTiles> placed = placed_tiles();
    const Ref<TileModel> model = tile_model(unit_of(sphere_mesh(0.5, 16, 8)));
    for (auto _ : state) benchmark::DoNotOptimize(tile_set(model, placed));
    per_tile(state);
}

// A torus whose limit surface has 288 charts, covered by 10,368 bricks.
LimitSurface covered_torus()
{
    Mesh cage = torus_mesh(1, 0.4, {24, 12});
    if (cage.points.empty()) cage.points = points_by_position(cage.positions);
    return LimitSurface(cage_of(ready_to_subdivide(cage)));
}

constexpr TileCover bricks{.pattern = TilePattern::brick, .per_face = 6};

void per_cell(benchmark::State& state, const Covering& covering)
{
    state.counters["tiles"] = static_cast<double>(covering.tiles().size());
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(covering.tiles().size()));
}

// Measures a new pattern: the cells and their nodes on the surface at rest.
void tiles_cover_layout(benchmark::State& state)
{
    const LimitSurface surface = covered_torus();
    const Covering covering(surface, bricks, {1, 1});
    for (auto _ : state)
        benchmark::DoNotOptimize(Covering(surface, bricks, {1, 1}).points(surface));
    per_cell(state, covering);
}

// Measures an edit of the base: heights, guard and patches. One thread.
void tiles_cover_pose(benchmark::State& state)
{
    const LimitSurface surface = covered_torus();
    const Covering covering(surface, bricks, {1, 1});
    const CoverCell cell{{0, 0, 0}, {1, 0.5, 0.3}};
    CoveringPose pose{covering.points(surface), {}, std::vector<char>(surface.net().size(), 0)};
    const ThreadLimit limit(1);
    for (auto _ : state) {
        pose.heights = heights_along_rows(covering, pose.points, 1);
        pose.heights = guarded_heights(covering, pose, 0.3).heights;
        for (std::uint32_t k = 0; k < covering.tiles().size(); ++k)
            benchmark::DoNotOptimize(patched_tile(cell, covering, pose, k));
    }
    per_cell(state, covering);
}

// Bends vertex after vertex by the definition, in double precision, to compare
// core/patches/tile_kernel.h with.
void bend_plainly(const Mesh& unit, const PlacedTile& tile, glm::vec3* positions,
                  glm::vec3* normals)
{
    for (std::size_t v = 0; v < unit.vertex_count(); ++v) {
        const glm::dvec3 at(unit.positions[v]), n(unit.normals[v]);
        const TilePoint t = tile_point(tile.patch, {at.x, at.y, tile.height * at.z + tile.base});
        const glm::dvec3 z = tile.height * t.z;
        positions[v] = t.p;
        normals[v] = glm::normalize(n.x * glm::cross(t.y, z) + n.y * glm::cross(z, t.x) +
                                    n.z * glm::cross(t.x, t.y));
    }
}

enum class Bending { plainly, as_wide_as_can_be, by_avx2 };

// Positions and normals of 400 tiles of 5,041 vertices, one thread, into memory that is there.
void tiles_vertices(benchmark::State& state, Bending bending)
{
    const bool plainly = bending == Bending::plainly;
    if (bending == Bending::by_avx2) hwy::SetSupportedTargetsForTest(HWY_AVX2);
    const Mesh unit = unit_of(sphere_mesh(0.5, 70, 71));
    const TileVertices vertices(unit);
    const Ref<PlacedTiles> placed = placed_tiles();
    constexpr std::size_t count = 400;
    std::vector<glm::vec3> positions(count * unit.vertex_count()), normals(positions.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) {
            const PlacedTile& tile = (*placed)[i];
            glm::vec3* const p = positions.data() + i * unit.vertex_count();
            glm::vec3* const n = normals.data() + i * unit.vertex_count();
            if (plainly) {
                bend_plainly(unit, tile, p, n);
            } else {
                const TilePowers powers = powers_of(tile);
                bend_vertices(vertices, powers, glm::vec3(powers.origin), {p, n, nullptr});
            }
        }
        benchmark::ClobberMemory();
    }
    hwy::SetSupportedTargetsForTest(0);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
}

// The mesh of all tiles, with its faces.
void tiles_bent(benchmark::State& state)
{
    const Ref<PlacedTiles> placed = placed_tiles();
    const Mesh unit = unit_of(sphere_mesh(0.5, 16, 8));
    for (auto _ : state) benchmark::DoNotOptimize(bent_tiles(unit, *placed));
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(placed->size() * unit.vertex_count()));
}

enum class Drawn { from_tiles, from_tiles_by_card, from_tiles_again, as_one_mesh };

// A draft of the torus with tiles of 281 vertices, 3 million in all, while the camera turns round
// it; or while the base moves, so that every patch is another.
void tiles_picture(benchmark::State& state, Drawn drawn)
{
    const gpu::HeadlessContext context;
    const Ref<TileModel> model = tile_model(unit_of(sphere_mesh(0.5, 20, 14)));
    const Ref<PlacedTiles> placed = placed_tiles();
    gpu::Picture picture;
    picture.draft = true;
    picture.samples = 1;
    picture.camera.eye = {0, -3.2, 2};
    gpu::Instance instance;
    instance.materials = make_ref(std::vector<Material>(1));
    instance.id = 1;
    instance.mesh = model->mesh;
    instance.tiles = tile_set(model, placed);
    if (drawn == Drawn::as_one_mesh) {
        instance.mesh = *instance.tiles->mesh;
        instance.tiles = nullptr;
    }
    gpu::Instance base;
    base.mesh = make_ref(TiledTorus::welded());
    base.id = 2;
    picture.instances = {instance, base};
    gpu::Renderer renderer;
    renderer.choose_tiles_on_card(drawn == Drawn::from_tiles_by_card);
    constexpr glm::ivec2 size_px{1280, 720};
    renderer.draw(picture, size_px);
    double angle = 0;
    for (auto _ : state) {
        angle += 0.02;
        picture.camera.eye = {3.2 * std::sin(angle), -3.2 * std::cos(angle), 2};
        if (drawn == Drawn::from_tiles_again) {
            std::vector<PlacedTile> moved = placed->all();
            for (PlacedTile& tile : moved)
                for (glm::dvec3& p : tile.patch.p) p.z += 0.1 * std::sin(angle);
            picture.instances.front().tiles =
                tile_set(model, make_ref(PlacedTiles(std::move(moved))));
        }
        renderer.draw(picture, size_px);
    }
    state.counters["tiles"] = static_cast<double>(placed->size());
    state.counters["drawn"] = static_cast<double>(renderer.tile_counts().drawn);
    state.counters["vertices"] = static_cast<double>(renderer.tile_counts().vertices);
    state.counters["all_vertices"] =
        static_cast<double>(placed->size() * model->mesh->vertex_count());
}

// Only the choice, and nothing drawn: which of the tiles on the torus, and of nine such layers, are
// seen and by which level, while the camera turns round them. What may hide them are depths of half
// the size of a picture, which the processor has already read back.
void tiles_choice(benchmark::State& state, bool on_card)
{
    const gpu::HeadlessContext context;
    const Ref<TileModel> model = tile_model(unit_of(sphere_mesh(0.5, 20, 14)));
    const Ref<TileSet> set = tile_set(model, placed_tiles());
    gpu::Picture picture;
    picture.draft = true;
    for (int i = 0; i < state.range(0); ++i) {
        gpu::Instance& layer = picture.instances.emplace_back();
        layer.id = i + 1;
        layer.mesh = model->mesh;
        layer.tiles = set;
    }
    constexpr glm::ivec2 size_px{640, 360};
    const std::vector<float> depths(640 * 360, 0.98f);
    gpu::Texture2D texture(GL_R32F, size_px);
    texture.bind(0);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_px.x, size_px.y, GL_RED, GL_FLOAT, depths.data());
    gpu::Mirror mirror;
    gpu::Programs programs;
    gpu::TileMirror tiles;
    tiles.choose_on_card(on_card);
    gpu::DevicePyramid pyramid;
    double angle = 0;
    for (auto _ : state) {
        angle += 0.02;
        picture.camera.eye = {3.2 * std::sin(angle), -3.2 * std::cos(angle), 2};
        const glm::dmat4 to_clip =
            projection_matrix(picture.camera, 0.1, 10) * view_matrix(picture.camera);
        tiles.update(picture, picture.camera, mirror, programs);
        if (on_card) {
            pyramid.write(programs, texture);
            tiles.show(&pyramid, to_clip, programs);
        } else {
            tiles.show(gpu::DepthPyramid(depths, size_px), to_clip);
        }
        glFinish();
    }
    state.counters["tiles"] = static_cast<double>(tiles.counts().tiles);
    state.counters["drawn"] = static_cast<double>(tiles.counts().drawn);
    state.counters["hidden"] = static_cast<double>(tiles.counts().hidden);
}

BENCHMARK(tiles_layout)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_charts)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_patches)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_guard)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_hulls)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_cover_layout)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_cover_pose)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_vertices, plain_loop, Bending::plainly)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_vertices, kernel, Bending::as_wide_as_can_be)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_vertices, kernel_avx2, Bending::by_avx2)->Unit(benchmark::kMillisecond);
BENCHMARK(tiles_bent)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_picture, turning, Drawn::from_tiles)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_picture, turning_by_card, Drawn::from_tiles_by_card)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_picture, moving, Drawn::from_tiles_again)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_picture, one_mesh, Drawn::as_one_mesh)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_choice, processor, false)
    ->MeasureProcessCPUTime()
    ->Arg(1)
    ->Arg(9)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tiles_choice, card, true)
    ->MeasureProcessCPUTime()
    ->Arg(1)
    ->Arg(9)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
