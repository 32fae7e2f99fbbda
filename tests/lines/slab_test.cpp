// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/lines/slab_drawing.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/slab_curves.h"
#include "tests/silhouette/scenes.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <random>

namespace trivar::testing {
namespace {

// Noise: bodies of all sizes, many of them in the faces of the grid.
VoxelGrid rough_grid(const glm::ivec3& size)
{
    std::mt19937 random(11);
    VoxelGrid out;
    out.size = size;
    std::vector<std::uint16_t> samples(out.count());
    for (std::uint16_t& each : samples) each = static_cast<std::uint16_t>(random() % 1000);
    out.samples = std::move(samples);
    return out;
}

SliceReader slices_of(const VoxelGrid& grid)
{
    return [&](const std::function<void(int, const VoxelGrid::Samples&)>& slice) {
        const SampleBox all{glm::ivec3(0), grid.size - 1};
        for (int k = 0; k < grid.size.z; ++k)
            std::visit(
                [&](const auto& samples) {
                    const auto count = static_cast<std::ptrdiff_t>(all.size().x) * all.size().y;
                    const auto from = samples.begin() + k * count;
                    slice(k, std::remove_cvref_t<decltype(samples)>(from, from + count));
                },
                grid.samples);
    };
}

// A plan with slabs of that many slices.
SlabPlan plan_of(const VoxelGrid& grid, int slices, const VoxelFieldOptions& options)
{
    return {grid.size, slices, slab_halo(options), 0};
}

struct BySlabs {
    Silhouettes curves, border;
};

BySlabs by_slabs(const VoxelGrid& grid, const SlabPlan& plan, const VoxelFieldOptions& options,
                 float level, const ViewPoint& view, float spacing)
{
    SlabCurves curves(view, {.spacing = spacing});
    for_slabs(plan, options, slices_of(grid), [&](const FieldSlab& slab) {
        curves.add(slab.field(), slab.level(level), slab.end());
    });
    return {curves.curves(), curves.border(spacing)};
}

// Expects the same curves, their points within `tolerance` voxels.
void expect_same(const Silhouettes& a, const Silhouettes& b, float tolerance)
{
    ASSERT_EQ(a.count(), b.count());
    ASSERT_EQ(a.points.size(), b.points.size());
    EXPECT_EQ(a.first, b.first);
    EXPECT_EQ(a.closed, b.closed);
    float farthest = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        ASSERT_EQ(a.points[i].edge, b.points[i].edge) << i;
        farthest = std::max(farthest, glm::distance(a.points[i].p, b.points[i].p));
    }
    EXPECT_LE(farthest, tolerance);
}

class SlabCurvesOf : public ::testing::TestWithParam<VoxelFieldOptions> {};

TEST_P(SlabCurvesOf, AreThoseOfTheWhole)
{
    const VoxelFieldOptions& options = GetParam();
    const VoxelGrid grid = rough_grid({21, 25, 104});
    const VoxelField whole(make_ref(grid), options);
    constexpr float level = 500.5f;
    const LevelMesh mesh = whole.level(level);
    for (const ViewPoint& view : some_views(grid.size, 2)) {
        const Silhouettes curves = SilhouetteFinder()(whole.field(), mesh, view, {.spacing = 0.4f}),
                          border = border_lines(whole.field(), mesh, 0.4f);
        ASSERT_GT(curves.count(), 20u);
        for (const int slices : {8, 40, 104}) {
            SCOPED_TRACE(slices);
            const BySlabs found =
                by_slabs(grid, plan_of(grid, slices, options), options, level, view, 0.4f);
            expect_same(found.curves, curves, 1e-4f);
            expect_same(found.border, border, 1e-4f);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SlabCurvesOf,
                         ::testing::Values(VoxelFieldOptions{},
                                           VoxelFieldOptions{.order = FieldOrder::quadratic},
                                           VoxelFieldOptions{.order = FieldOrder::linear},
                                           VoxelFieldOptions{.spline = FieldSpline::smoothing},
                                           VoxelFieldOptions{.blur = 3}));

// Returns the deviation of coefficients, relative to the greatest, by the number of slices on
// either side.
double deviation(const VoxelGrid& grid, int halo)
{
    const auto& samples = std::get<std::vector<std::uint16_t>>(grid.samples);
    const ScalarField<float> whole(std::span<const std::uint16_t>(samples), grid.size);
    const std::size_t slice =
        static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
    const int first = 48, count = 16;
    const std::span held =
        std::span(samples).subspan(slice * static_cast<std::size_t>(first - halo),
                                   slice * static_cast<std::size_t>(count + 2 * halo));
    const ScalarField<float> slab(held, grid.size, first - halo, FieldSpline::interpolating,
                                  FieldOrder::cubic);
    double farthest = 0, greatest = 0;
    for (int k = first; k < first + count; ++k)
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i) {
                const double a = slab.coefficient(i, j, k), b = whole.coefficient(i, j, k);
                farthest = std::max(farthest, std::abs(a - b));
                greatest = std::max(greatest, std::abs(b));
            }
    return farthest / greatest;
}

TEST(SlabField, HasTheBitsOfTheWholeWithThirtyTwoSlicesOnEitherSide)
{
    const VoxelGrid grid = rough_grid({40, 30, 128});
    EXPECT_EQ(deviation(grid, 32), 0);
    EXPECT_LE(deviation(grid, 16), 2e-7); // a bit of a float
    EXPECT_LE(deviation(grid, 8), 1e-4);
}

TEST(SlabPlan, FitsIntoTheMemoryOrIsRefused)
{
    const glm::ivec3 size(2048, 2048, 2048);
    for (const std::uint64_t gigabytes : {2, 4, 8, 64}) {
        const SlabPlan plan = slab_plan(size, 2, {}, gigabytes << 30);
        EXPECT_LE(plan.bytes, gigabytes << 30);
        EXPECT_EQ(plan.slices % 8, 0);
        EXPECT_GE(plan.slices, 8);
        EXPECT_EQ(plan.halo, gigabytes > 2 ? 32 : plan.halo);
    }
    EXPECT_THROW(slab_plan(size, 2, {}, std::uint64_t{1} << 30), Rejected);
}

// Data that are looked at as a whole and by slabs.
struct Waves {
    SampledField from = sampled("waves", 96);
    VoxelGrid grid = [this] {
        VoxelGrid out;
        out.size = from.size;
        out.samples = in_single_precision(from.samples);
        return out;
    }();
    VoxelField whole{make_ref(grid), {}};
    float level = static_cast<float>(from.level);
    LevelMesh mesh = whole.level(level);
};

TEST(SlabDrawing, HidesWhatTheWholeHides)
{
    const Waves waves;
    const auto& [from, grid, whole, level, mesh] = waves;
    const DrawingView view{image_of({1, 0.4, -0.7}), {glm::dvec4(1, 0.4, -0.7, 0)}};
    const Silhouettes curves = SilhouetteFinder()(whole.field(), mesh, view.from);
    const std::vector<char> hidden =
        hidden_points(curves, view.from, {whole.field(), whole.hulls(), level, LevelSide::above});
    const SlabPlan plan = plan_of(grid, 16, {});
    std::vector<char> found = hollow_points(curves, LevelSide::above);
    for_slabs(plan, {}, slices_of(grid), [&](const FieldSlab& slab) {
        found = hidden_by(std::move(found), curves, view.from,
                          std::vector{slab.body(level, LevelSide::above)});
    });
    std::size_t other = 0;
    for (std::size_t i = 0; i < hidden.size(); ++i) other += found[i] != hidden[i];
    EXPECT_GT(std::ranges::count(hidden, 1), 100);
    EXPECT_LE(static_cast<double>(other), 2e-3 * static_cast<double>(hidden.size()));
}

TEST(SlabDrawing, DrawsWhatTheWholeGives)
{
    const Waves waves;
    const auto& [from, grid, whole, level, mesh] = waves;
    const DrawingView view{image_of({0.3, 1, -0.5}), {glm::dvec4(0.3, 1, -0.5, 0)}};
    const DrawnLevel drawn{.name = "a", .mesh = mesh};
    const LevelDrawing at_once = draw_levels(whole.field(), whole.hulls(), {&drawn, 1}, view);
    const SlabLevel slab_level{.name = "a", .level = level};
    const LevelDrawing by_slab =
        draw_levels_by_slabs(plan_of(grid, 24, {}), {}, slices_of(grid), {&slab_level, 1}, view);
    const auto length = [](const LevelDrawing& drawing) {
        double sum = 0;
        for (const InkedLine& line : drawing.layers.at(0).lines)
            for (std::size_t i = 1; i < line.points.size(); ++i)
                sum += glm::distance(line.points[i - 1].at, line.points[i].at);
        return sum;
    };
    ASSERT_GT(at_once.layers.at(0).lines.size(), 5u);
    EXPECT_NEAR(length(by_slab), length(at_once), 0.01 * length(at_once));
}

} // namespace
} // namespace trivar::testing
