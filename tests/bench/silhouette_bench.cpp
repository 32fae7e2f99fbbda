// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "core/level/level_surface.h"
#include "core/level/voxel_field.h"
#include "core/lines/level_drawing.h"
#include "core/lines/mesh_drawing.h"
#include "core/mesh/primitives.h"
#include "core/silhouette/certified.h"
#include "core/voxels/read_volume.h"
#include "tests/silhouette/scenes.h"
#include "tests/support/fixtures.h"

#include <benchmark/benchmark.h>
#include <map>
#include <memory>

// The silhouettes of 256^3 samples: sums of bumps, waves [Marschner, Lobb 1994], and a scanned
// cranium of 256 x 256 x 108 samples where there is real data; views turn from one to the next.
namespace trivar {
namespace {

using testing::Sampled;

constexpr double cranium_bone = 226;

Ref<VoxelGrid> grid_of(const testing::SampledField& from)
{
    VoxelGrid grid;
    grid.size = from.size;
    grid.samples = testing::in_single_precision(from.samples);
    return make_ref(std::move(grid));
}

struct BenchVolume {
    std::shared_ptr<const VoxelField> field;
    LevelMesh mesh;
    double level = 0;
};

Ref<VoxelGrid> cranium_grid()
{
    const std::string folder = testing::real_data_folder();
    if (folder.empty()) return nullptr;
    ReadVolumeOptions options;
    options.raw = RawLayout{{.size = {256, 256, 108}, .type = SampleType::i16}};
    options.spacing = {0.957, 0.957, 1.5};
    return make_ref(read_volume(folder + "/volumes/invesalius-cranium/matrix.dat", options).grid);
}

Ref<VoxelGrid> bench_grid(const std::string& name, int n, double& level)
{
    if (name == "cranium") {
        level = cranium_bone;
        return cranium_grid();
    }
    const testing::SampledField from = testing::sampled(name, n);
    level = from.level;
    return grid_of(from);
}

// Null where there is no real data.
const BenchVolume* bench_volume(const std::string& name, int n = 256)
{
    keep_freed_memory(); // as the program does
    static std::map<std::pair<std::string, int>, BenchVolume> known;
    BenchVolume& out = known[{name, n}];
    if (out.field) return &out;
    const Ref<VoxelGrid> grid = bench_grid(name, n, out.level);
    if (!grid) return nullptr;
    out.field = std::make_shared<const VoxelField>(grid, VoxelFieldOptions{});
    out.mesh = out.field->level(out.level);
    return &out;
}

bool lacks(const BenchVolume* volume, benchmark::State& state)
{
    if (volume) return false;
    state.SkipWithError("no folder of real data");
    return true;
}

ViewPoint turned_view(int step)
{
    const double angle = 0.02 * step;
    return {{0.48 * std::cos(angle), 0.48 * std::sin(angle) + 0.6, 0.64, 0}};
}

void silhouette_prepare(benchmark::State& state, const char* name)
{
    double level = 0;
    const Ref<VoxelGrid> grid = bench_grid(name, 256, level);
    if (!grid) return state.SkipWithError("no folder of real data");
    std::size_t bytes = 0;
    for (auto _ : state) bytes = VoxelField(grid, {}).bytes();
    state.counters["bytes_per_voxel"] =
        static_cast<double>(bytes) / static_cast<double>(grid->count());
}
BENCHMARK_CAPTURE(silhouette_prepare, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_prepare, cranium, "cranium")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Finds the lines as while a level is dragged: with half the samples along each axis.
void silhouette_dragged(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name);
    if (lacks(volume, state)) return;
    const VoxelField field(make_ref(volume->field->grid()), {.coarsen = 2});
    SilhouetteFinder find;
    std::size_t points = 0;
    for (auto _ : state)
        points = find(field.field(), field.level(volume->level), turned_view(0)).points.size();
    state.counters["points"] = static_cast<double>(points);
}

void silhouette_level(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name);
    if (lacks(volume, state)) return;
    LevelMesh mesh;
    for (auto _ : state) mesh = volume->field->level(volume->level);
    state.counters["triangles"] = static_cast<double>(mesh.triangle_count());
    state.counters["ns_per_triangle"] = benchmark::Counter(
        static_cast<double>(mesh.triangle_count()) * 1e-9,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["bytes_per_voxel"] = static_cast<double>(volume->field->bytes() + mesh.bytes()) /
                                        static_cast<double>(volume->field->grid().count());
}
BENCHMARK_CAPTURE(silhouette_level, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_level, waves, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_level, cranium, "cranium")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_dragged, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_dragged, waves, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_dragged, cranium, "cranium")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void silhouette_view(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name);
    if (lacks(volume, state)) return;
    SilhouetteFinder find;
    int step = 0;
    Silhouettes lines;
    for (auto _ : state) lines = find(volume->field->field(), volume->mesh, turned_view(++step));
    state.counters["points"] = static_cast<double>(lines.points.size());
    state.counters["tested"] = static_cast<double>(lines.tested);
    state.counters["crossed"] = static_cast<double>(lines.crossed);
}
BENCHMARK_CAPTURE(silhouette_view, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_view, waves, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_view, cranium, "cranium")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// All of a drawing: what is hidden, strokes and ink, too.
void silhouette_drawing(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name);
    if (lacks(volume, state)) return;
    const DrawnLevel level{"level", volume->mesh, LevelSide::above, {}};
    int step = 0;
    for (auto _ : state) {
        const ViewPoint view = turned_view(++step);
        benchmark::DoNotOptimize(draw_levels(volume->field->field(), volume->field->hulls(),
                                             std::span(&level, 1),
                                             {testing::image_of(glm::dvec3(view.at)), view}));
    }
}
BENCHMARK_CAPTURE(silhouette_drawing, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_drawing, waves, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_drawing, cranium, "cranium")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Ridges, valleys, parabolic lines and isophotes of a level, which are the same in every view.
void silhouette_fixed_lines(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name, 128);
    if (lacks(volume, state)) return;
    const MoreLines all{.ridges = true, .valleys = true, .parabolic = true, .isophotes = 4};
    const ScalarField<float> smooth = smooth_field(*volume->field, all.smoothing);
    for (auto _ : state)
        benchmark::DoNotOptimize(level_lines(*volume->field, smooth, volume->mesh, LevelSide::above,
                                             glm::dmat4(1), all));
    state.counters["triangles"] = static_cast<double>(volume->mesh.triangle_count());
}
BENCHMARK_CAPTURE(silhouette_fixed_lines, gauss_128, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_fixed_lines, waves_128, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void silhouette_suggestive(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name, 128);
    if (lacks(volume, state)) return;
    const MoreLines wanted{.suggestive = true};
    const ScalarField<float> smooth = smooth_field(*volume->field, wanted.smoothing);
    const LevelLines lines =
        level_lines(*volume->field, smooth, volume->mesh, LevelSide::above, glm::dmat4(1), wanted);
    int step = 0;
    std::size_t points = 0;
    for (auto _ : state)
        points = lines_seen(lines, wanted, turned_view(++step), volume->field->field(),
                            volume->mesh.level)[0]
                     .lines.points.size();
    state.counters["triangles"] = static_cast<double>(volume->mesh.triangle_count());
    state.counters["points"] = static_cast<double>(points);
}
BENCHMARK_CAPTURE(silhouette_suggestive, gauss_128, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_suggestive, waves_128, "waves")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// Prepares the shape in which the lines of a mesh are found, with all further lines, or finds a
// view of them.
void silhouette_of_mesh(benchmark::State& state, bool view)
{
    const Ref<Mesh> torus = make_ref(torus_mesh(1, 0.4, {256, 128}));
    const LineDrawing drawing{.more = {.suggestive = true, .ridges = true, .smoothing = 1}};
    const ShapedMesh shaped = shaped_mesh(*torus, drawing);
    std::vector<RayScene::Entry> entries{{std::make_shared<const RayMesh>(torus), glm::dmat4(1)}};
    const RayScene scene(std::move(entries));
    const glm::dmat4 here(1);
    Camera camera;
    camera.eye = {3, -3, 2};
    camera.size_px = {1280, 720};
    Box box;
    for (const glm::vec3& p : torus->positions) box.add(glm::dvec3(p));
    std::size_t points = 0;
    for (auto _ : state)
        if (view) {
            camera.eye.x += 0.01;
            points = 0;
            for (const KindStrokes& each :
                 mesh_strokes(shaped, drawing, drawing_view(camera, here, box), {scene, here}))
                for (const Stroke& stroke : each.strokes) points += stroke.points.size();
        } else {
            benchmark::DoNotOptimize(shaped_mesh(*torus, drawing));
        }
    state.counters["triangles"] = static_cast<double>(shaped.shape.surface.corners.size() / 3);
    if (view) state.counters["points"] = static_cast<double>(points);
}
BENCHMARK_CAPTURE(silhouette_of_mesh, first, false)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_of_mesh, view, true)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void silhouette_surface(benchmark::State& state, const char* name)
{
    const BenchVolume* volume = bench_volume(name);
    if (lacks(volume, state)) return;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            volume->field->surface(volume->mesh, LevelSide::above, glm::dmat4(1)));
}
BENCHMARK_CAPTURE(silhouette_surface, gauss, "gauss")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void silhouette_certified(benchmark::State& state, const char* name, int n, int depth)
{
    const BenchVolume* volume = bench_volume(name, n);
    if (lacks(volume, state)) return;
    std::size_t open = 0;
    int step = 0;
    for (auto _ : state)
        open = certified_silhouettes(volume->field->field(), volume->field->hulls(),
                                     volume->mesh.level, turned_view(++step), depth)
                   .open;
    state.counters["open"] = static_cast<double>(open);
}
BENCHMARK_CAPTURE(silhouette_certified, gauss_64_sixteenth, "gauss", 64, 4)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_certified, waves_64_sixteenth, "waves", 64, 4)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_certified, gauss_256_eighth, "gauss", 256, 3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_certified, waves_256_eighth, "waves", 256, 3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(silhouette_certified, cranium_eighth, "cranium", 256, 3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace
} // namespace trivar
