// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes over an edge behind which other surfaces are seen far off.
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/placement/center_line.h"
#include "core/placement/depth_jumps.h"
#include "core/placement/sketch.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::AllOf, ::testing::HasSubstr, ::testing::ThrowsMessage;

constexpr double table_height = 1, valley_height = -6;     // metres
constexpr glm::dvec3 beyond_them{-0.6, 14, valley_height}; // seen over their edge

// Two tables side by side with a gap between them, high above a valley. They end at y = 0.
RayScene tables(double gap, bool valley = true)
{
    std::vector<RayScene::Entry> entries;
    const auto add = [&](Mesh mesh, const glm::dvec3& at) {
        glm::dmat4 there(1);
        there[3] = glm::dvec4(at, 1);
        entries.push_back({std::make_shared<const RayMesh>(make_ref(std::move(mesh))), there,
                           static_cast<int>(entries.size())});
    };
    for (const double side : {-1, 1})
        add(box_mesh({3, 3, 1}, {8, 8, 8}), {side * (1.5 + gap / 2), -1.5, table_height - 0.5});
    if (valley) add(plane_mesh({60, 60}, {4, 4}), {0, 0, valley_height});
    return RayScene(std::move(entries));
}

Camera before_them()
{
    return from_the_side({0, -4, 4});
}

PlacementParameters bridging(bool on = true)
{
    return {.width = 0.2, .height = 0.1, .bridge_jumps = on};
}

Sketch along_the_tables()
{
    return stroke_over(before_them(), {{-1, -0.5, table_height}, {1, -0.5, table_height}});
}

TEST(DepthJumps, AreFollowedAsInOlderScenesUnlessTheyAreBridged)
{
    const Placement torn = placed(along_the_tables(), tables(0.4), bridging(false));
    EXPECT_GT(torn.report.length_world, 3);
    EXPECT_GT(torn.report.largest_stretch, 4);
}

TEST(DepthJumps, AreBridgedOnTheSurfaceBeforeThem)
{
    const RayScene scene = tables(0.4);
    const Placement out = placed(along_the_tables(), scene, bridging());
    EXPECT_TRUE(out.report.folds.empty());
    EXPECT_NEAR(out.report.length_world, 2, 0.1) << "as long as it was drawn";
    for (const StripNode& node : out.nodes) EXPECT_NEAR(node.p_world.z, table_height, 0.2);
    EXPECT_LT(penetration(out.contact, before_them(), scene, 60), 1e-3);
    EXPECT_THAT(out.report.notices,
                ::testing::Contains(HasSubstr("% along the stroke; the model spans the gap")));
}

TEST(DepthJumps, AreSaidWhereTheStrokeDoesNotComeBack)
{
    const Camera camera = before_them();
    const glm::dvec2 on = project(camera, {-0.8, -0.8, table_height}).p_px,
                     behind = project(camera, beyond_them).p_px;
    for (const bool back : {false, true}) {
        const Sketch sketch = back ? stroke(camera, {behind, on}) : stroke(camera, {on, behind});
        EXPECT_THAT([&] { placed(sketch, tables(0.4), bridging()); },
                    ThrowsMessage<Rejected>(AllOf(HasSubstr("% along the stroke it jumps"),
                                                  HasSubstr("draw it on one of them"))));
    }
}

TEST(DepthJumps, AreNoneWhereTheStrokeBeginsOrEndsInTheAir)
{
    const Camera camera = before_them();
    const RayScene scene = tables(0.4, false);
    const glm::dvec2 on = project(camera, {-0.8, -0.8, table_height}).p_px,
                     off = project(camera, beyond_them).p_px;
    for (const auto& way : {std::vector{on, off}, std::vector{off, on}}) {
        const Curve<glm::dvec2> center = fit_sketch(stroke_points(stroke(camera, way)));
        RayGrid line = center_line(center, 41, camera, scene, false);
        EXPECT_GT(line.missed_share(), 0.2);
        std::vector<glm::dvec2> points_px;
        for (const double a : line.a) points_px.push_back(evaluate(center, a).value);
        DepthJumps jumps(camera, scene, false);
        EXPECT_TRUE(jumps.bridge(line, points_px)->empty());
        EXPECT_TRUE(jumps.found().empty());
    }
}

TEST(DepthJumps, OntoALowModelThatLiesThereAreFollowed)
{
    // A box on a plane, seen from low before it: deep along the sight, but hardly high.
    glm::dmat4 there(1);
    there[3] = {0, 0, 0.1, 1};
    std::vector<RayScene::Entry> entries{
        {std::make_shared<const RayMesh>(make_ref(plane_mesh({20, 20}, {4, 4}))), glm::dmat4(1), 0},
        {std::make_shared<const RayMesh>(make_ref(box_mesh({2, 0.3, 0.2}, {8, 8, 8}))), there, 1}};
    const RayScene scene(std::move(entries));
    const Camera camera = from_the_side({0, -6, 1.5});
    for (const double begin : {-1.6, -0.8}) {
        const Sketch over = stroke_over(camera, {{begin, 0, 0.2}, {0.8, 0, 0.2}});
        const Placement out = placed(over, scene, bridging());
        EXPECT_TRUE(out.report.folds.empty());
    }
}

TEST(DepthJumps, AreBridgedWhereTheWayDownAndUpWouldBeTooLong)
{
    PlacementParameters p = bridging();
    p.width = p.height = 0; // of the model's proportions, so that they grow with the way
    const Placement out = placed(along_the_tables(), tables(0.4), p);
    EXPECT_NEAR(out.report.length_world, 2, 0.1);
}

TEST(DepthJumps, OfAStepThatIsSeenWholeAreNone)
{
    // Down a cliff towards the camera: the cliff itself is seen.
    const RayScene steps = scene_of(height_field(
        8, 160, [](double, double y) { return y > 0 ? 1.0 : std::max(0.0, 1 + 8 * y); }));
    const Sketch down = stroke_over(from_the_side({0, -4, 3}), {{0, 1, 1}, {0, -1, 0}});
    EXPECT_EQ(placed(down, steps, bridging()).volume.displacement.points,
              placed(down, steps, bridging(false)).volume.displacement.points);
}

TEST(DepthJumps, ChangeNoBitWhereThereAreNone)
{
    const RayScene waves = scene_of(height_field(
        4, 60, [](double x, double y) { return 0.1 * std::sin(5 * x) * std::cos(4 * y); }));
    const Sketch across = stroke_over(from_the_side(), {{-1, 0, 0}, {1, 0.3, 0}});
    EXPECT_EQ(placed(across, waves, bridging()).volume.displacement.points,
              placed(across, waves, bridging(false)).volume.displacement.points);
}

} // namespace
} // namespace trivar
