// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/level_drawing.h"
#include "tests/silhouette/scenes.h"

#include <gtest/gtest.h>

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
    EXPECT_EQ(quick.open, 0u);
    const LevelDrawing certified =
        draw_levels(scene.field, hulls, levels, view, {.certified_depth = 2});
    EXPECT_GT(certified.open, 0u);
    EXPECT_EQ(certified.layers.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Of, LevelDrawings, ::testing::Bool());

} // namespace
} // namespace trivar::testing
