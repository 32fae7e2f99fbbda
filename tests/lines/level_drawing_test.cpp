// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_drawing.h"
#include "tests/silhouette/scenes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace trivar::testing {
namespace {

// Voxels of uneven sides, turned and mirrored, somewhere in the world.
glm::dmat4 oblique_space()
{
    glm::dmat4 out(1);
    out[0] = {0, 0.02, 0.002, 0};
    out[1] = {0.03, 0, 0, 0};
    out[2] = {0.003, 0, 0.05, 0};
    out[3] = {4, -2, 1, 1};
    return out;
}

class LevelDrawings : public ::testing::TestWithParam<bool> {
protected:
    LevelDrawings()
    {
        camera_.target = glm::dvec3(oblique_space() * glm::dvec4(glm::dvec3(15.5), 1));
        camera_.eye = camera_.target + glm::dvec3(3, -4, 2);
        camera_.perspective = GetParam();
        camera_.height_world = 3;
        camera_.size_px = {640, 480};
    }
    Camera camera_;
};

TEST_P(LevelDrawings, LieWhereTheCameraSeesThem)
{
    const Sampled scene("sphere", 32);
    const FieldHulls hulls(scene.field);
    const LevelMesh mesh = scene.level();
    const DrawnLevel level{"ball", mesh, LevelSide::below};
    const DrawingView view = drawing_view(camera_, oblique_space(), scene.from.size);
    const auto [lines, border] = level_strokes(scene.field, hulls, level, view);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_loop());
    EXPECT_TRUE(border.empty());
    for (const StrokePoint& p : lines[0].points) {
        const glm::dvec3 world(oblique_space() * glm::dvec4(glm::dvec3(p.p), 1));
        EXPECT_LE(glm::distance(project(camera_, world).p_px, glm::dvec2(p.at)), 0.05);
        EXPECT_GT(p.depth, 0);
        EXPECT_LT(p.depth, 1);
    }
}

// Seen from above, the low one of two hills is broader, and nearly under the level.
TEST_P(LevelDrawings, RatherKeepLinesThatLastAsTheLevelChanges)
{
    const glm::ivec3 size(48, 24, 24);
    std::vector<float> samples;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::vec3 p(i, j, k), low = (p - glm::vec3(34, 12, 12)) / 55.0f,
                                            high = (p - glm::vec3(9, 12, 12)) / 4.5f;
                samples.push_back(std::max(0.52f * std::exp(-glm::dot(low, low)),
                                           1.1f * std::exp(-glm::dot(high, high))));
            }
    const ScalarField<float> field(std::span<const float>(samples), size);
    const FieldHulls hulls(field);
    const auto level_at = [&](float at) {
        return level_mesh(field, std::span<const float>(samples), at);
    };
    const LevelMesh mesh = level_at(0.505f);
    const std::vector<LevelMesh> nearby{level_at(0.48f), level_at(0.53f)};
    DrawnLevel level{"hills", mesh};
    level.border = false;
    level.more.amount = 0.25f;
    const glm::dvec3 sight(0, 1, 0);
    const DrawingView view{image_of(sight), {glm::dvec4(sight, 0)}};
    const auto kept_at = [&] {
        const LevelDrawing drawn = draw_levels(field, hulls, std::span(&level, 1), view);
        EXPECT_EQ(drawn.layers[0].lines.size(), 1u);
        return drawn.layers[0].lines[0].points[0].at.x;
    };
    const float broad = kept_at();
    level.nearby = nearby;
    const float lasting = kept_at();
    EXPECT_NE(broad < 500 + 4 * 20, lasting < 500 + 4 * 20);
}

TEST(LevelDrawing, KeepsItsShareOfLinesFromViewToView)
{
    const Sampled scene("noise", 24);
    const FieldHulls hulls(scene.field);
    const LevelMesh mesh = scene.level();
    DrawnLevel level{"noise", mesh};
    level.more.amount = 0.3f;
    // How many lines come or go in a turn, of those that both views could draw.
    const auto changes = [&](bool remembers) {
        std::map<std::string, LineIds> ids;
        std::map<std::string, std::vector<std::uint64_t>> kept;
        LevelDrawingOptions options;
        options.ids = [&](const std::string& layer) -> LineIds& { return ids[layer]; };
        if (remembers)
            options.kept = [&](const std::string& layer) -> std::vector<std::uint64_t>& {
                return kept[layer];
            };
        std::size_t out = 0;
        std::set<std::uint64_t> before;
        for (int step = 0; step < 24; ++step) {
            const double angle = 0.3 + 0.005 * step;
            const glm::dvec3 sight(std::cos(angle), std::sin(angle), 0.2);
            const LevelDrawing drawn =
                draw_levels(scene.field, hulls, std::span(&level, 1),
                            {image_of(sight), {glm::dvec4(sight, 0)}}, options);
            std::set<std::uint64_t> now;
            for (const InkedLine& line : drawn.layers[0].lines) now.insert(line.id);
            std::vector<std::uint64_t> differ;
            std::ranges::set_symmetric_difference(before, now, std::back_inserter(differ));
            if (step > 0) out += differ.size();
            before = std::move(now);
        }
        return out;
    };
    const std::size_t with = changes(true), without = changes(false);
    EXPECT_LT(10 * with, 8 * without) << with << " " << without;
}

TEST_P(LevelDrawings, HaveALayerForEachLevelAndAreCertifiedWhereThatIsAsked)
{
    const Sampled scene("waves", 20);
    const FieldHulls hulls(scene.field);
    const LevelMesh low = scene.level(0.4), high = scene.level(0.6);
    const std::vector<DrawnLevel> levels{{"low", low}, {"high", high}};
    const DrawingView view = drawing_view(camera_, oblique_space(), scene.from.size);
    const LevelDrawing quick = draw_levels(scene.field, hulls, levels, view);
    ASSERT_EQ(quick.layers.size(), 2u);
    EXPECT_EQ(quick.layers[1].name, "high");
    EXPECT_FALSE(quick.layers[0].lines.empty()); // the border's at least
    EXPECT_EQ(quick.gaps.open, 0u);
    const LevelDrawing certified =
        draw_levels(scene.field, hulls, levels, view, {.certified_depth = 2});
    EXPECT_GT(certified.gaps.open, 0u);
    EXPECT_EQ(certified.layers.size(), 2u);
}

// The level of a bell just below its top is a ball of 0.1 voxel: less than a pixel across.
TEST(LevelDrawing, LeavesOutNoShortLineThatIsCertified)
{
    const glm::ivec3 size(12);
    std::vector<float> samples;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::vec3 d = glm::vec3(i, j, k) - 6.0f;
                samples.push_back(std::exp(-glm::dot(d, d) / 8));
            }
    const ScalarField<float> field(std::span<const float>(samples), size);
    const FieldHulls hulls(field);
    const LevelMesh mesh = level_mesh(field, std::span<const float>(samples), 0.993f);
    const DrawnLevel level{"bell", mesh};
    const glm::dvec3 sight(0, 1, 0);
    const DrawingView view{image_of(sight), {glm::dvec4(sight, 0)}};
    const auto lines = [&](int depth) {
        return level_strokes(field, hulls, level, view, {.certified_depth = depth})[0];
    };
    EXPECT_TRUE(lines(-1).empty());
    const std::vector<Stroke> certified = lines(4);
    ASSERT_EQ(certified.size(), 1u);
    EXPECT_TRUE(certified[0].is_loop());
    EXPECT_LT(certified[0].length(), 8);
    EXPECT_GT(certified[0].length(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Of, LevelDrawings, ::testing::Bool());

} // namespace
} // namespace trivar::testing
