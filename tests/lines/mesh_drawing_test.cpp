// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/mesh_drawing.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"

#include <cmath>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

Camera camera_from(const glm::dvec3& eye, bool perspective)
{
    Camera out;
    out.eye = eye;
    out.perspective = perspective;
    out.height_world = 3;
    out.size_px = {800, 800};
    return out;
}

std::vector<KindStrokes> drawn(const Mesh& mesh, const LineDrawing& drawing, const Camera& camera,
                               const glm::dmat4& to_world = glm::dmat4(1))
{
    const Ref<Mesh> ref = make_ref(mesh);
    const RayScene scene({{std::make_shared<const RayMesh>(ref), to_world}});
    return mesh_strokes(shaped_mesh(mesh, drawing), drawing,
                        drawing_view(camera, to_world, bounding_box(mesh)), {scene, to_world});
}

double length_of(const std::vector<KindStrokes>& all, LineKind kind, bool hidden)
{
    double out = 0;
    for (const KindStrokes& each : all)
        for (const Stroke& stroke : each.strokes)
            if (each.kind == kind && stroke.hidden == hidden) out += stroke.length();
    return out;
}

TEST(MeshOutlines, OfABallLieOnItsGreatCircleWithTheSquareOfTheSides)
{
    const auto worst = [](int n) {
        const MeshShape shape = mesh_shape(sphere_mesh(1, 2 * n, n), 60);
        EXPECT_TRUE(shape.closed);
        EXPECT_TRUE(shape.edges.empty());
        const glm::dvec3 sight = glm::normalize(glm::dvec3(1, 2, -0.7));
        const Silhouettes lines = outlines(shape.surface, {glm::dvec4(sight, 0)});
        EXPECT_EQ(lines.count(), 1u);
        EXPECT_TRUE(lines.closed[0]);
        double out = 0;
        for (const SilhouettePoint& point : lines.points) {
            const glm::dvec3 p(point.p);
            out = std::max({out, std::abs(glm::dot(p, sight)), 1 - glm::length(p)});
            EXPECT_LT(point.bend, 0);
        }
        return out;
    };
    EXPECT_LE(worst(32), 0.006);
    EXPECT_GE(worst(16) / worst(32), 3);
    EXPECT_GE(worst(32) / worst(64), 3);
}

TEST(MeshOutlines, OfABallAreSeenAllRoundFromFarAndNear)
{
    for (const bool perspective : {false, true})
        for (const int n : {6, 12, 40}) {
            const std::vector<KindStrokes> all =
                drawn(sphere_mesh(1, 2 * n, n), {}, camera_from({3, -4, 2}, perspective));
            EXPECT_EQ(length_of(all, LineKind::silhouettes, true), 0) << n;
            ASSERT_EQ(all.size(), 1u);
            ASSERT_EQ(all[0].strokes.size(), 1u);
            EXPECT_TRUE(all[0].strokes[0].is_loop());
        }
}

TEST(MeshLines, OfABoxAreItsNineEdgesInSight)
{
    const Mesh box = box_mesh(glm::dvec3(1), glm::ivec3(2));
    const Camera camera = camera_from({3, -4, 2.5}, false);
    const std::vector<KindStrokes> all = drawn(box, {}, camera);
    const double unit = 800.0 / 3; // pixels
    double seen = 0, hidden = 0;   // lengths of the edges as they should be
    const glm::dvec3 to_eye = glm::normalize(camera.eye);
    for (int axis = 0; axis < 3; ++axis) {
        const double length = unit * std::sqrt(1 - to_eye[axis] * to_eye[axis]);
        seen += 3 * length;
        hidden += length;
    }
    EXPECT_NEAR(length_of(all, LineKind::silhouettes, false) +
                    length_of(all, LineKind::creases, false),
                seen, 0.01 * seen);
    EXPECT_NEAR(length_of(all, LineKind::creases, true), hidden, 0.02 * hidden);
    EXPECT_NEAR(length_of(all, LineKind::silhouettes, false), seen * 2 / 3, 0.01 * seen);
}

TEST(MeshLines, OfABoxAreWholeAtItsCorners)
{
    for (const bool perspective : {false, true})
        for (const KindStrokes& kind : drawn(box_mesh(glm::dvec3(1), glm::ivec3(1)), {},
                                             camera_from({3, -4, 2.5}, perspective)))
            for (const Stroke& stroke : kind.strokes)
                EXPECT_FALSE(stroke.tapers_first || stroke.tapers_last);
}

TEST(MeshLines, OfASheetAreItsBorderFromBothSides)
{
    const Mesh sheet = plane_mesh({1, 1}, {4, 4});
    for (const double z : {2.0, -2.0}) {
        const std::vector<KindStrokes> all = drawn(sheet, {}, camera_from({0.1, -3, z}, true));
        EXPECT_GT(length_of(all, LineKind::borders, false), 500);
        EXPECT_EQ(length_of(all, LineKind::borders, true), 0);
        EXPECT_EQ(length_of(all, LineKind::creases, false), 0);
    }
}

TEST(MeshLines, AreHiddenByWhatIsBeforeThem)
{
    const Ref<Mesh> ball = make_ref(sphere_mesh(0.5, 48, 24)),
                    wall = make_ref(box_mesh({4, 0.1, 4}, glm::ivec3(1)));
    glm::dmat4 before(1);
    before[3] = {0, -2, 0, 1};
    const RayScene scene({{std::make_shared<const RayMesh>(ball), glm::dmat4(1)},
                          {std::make_shared<const RayMesh>(wall), before}});
    const DrawingView view =
        drawing_view(camera_from({0, -8, 0}, false), glm::dmat4(1), bounding_box(*ball));
    const std::vector<KindStrokes> all =
        mesh_strokes(shaped_mesh(*ball, {}), {}, view, {scene, glm::dmat4(1)});
    EXPECT_EQ(length_of(all, LineKind::silhouettes, false), 0);
    EXPECT_GT(length_of(all, LineKind::silhouettes, true), 500);
}

TEST(MeshLines, OfACylinderAreTwoSidesAndTwoRims)
{
    const std::vector<KindStrokes> all =
        drawn(cylinder_mesh(0.5, 1, 64, 8), {}, camera_from({3, -4, 2}, false));
    const double unit = 800.0 / 3, height = unit * std::hypot(3, 4) / std::sqrt(29.0);
    EXPECT_GT(length_of(all, LineKind::silhouettes, false), 2 * height * 0.98);
    EXPECT_GT(length_of(all, LineKind::creases, false), 0); // the rim that faces the eye
    EXPECT_GT(length_of(all, LineKind::creases, true) + length_of(all, LineKind::silhouettes, true),
              0);
}

TEST(MeshShapes, HaveSharpEdgesBetweenPatches)
{
    const MeshShape box = mesh_shape(box_mesh(glm::dvec3(1), glm::ivec3(3)), 35);
    EXPECT_EQ(box.edges.size(), 12u * 3);
    EXPECT_EQ(box.points.size(), 56u);
    EXPECT_EQ(box.surface.positions.size(), 6u * 16);
    for (const SurfaceBend& bend : box.surface.bends) EXPECT_NEAR(bend.mean(), 0, 1e-6);
    const Silhouettes lines = edge_lines(box.points, box.edges);
    EXPECT_EQ(lines.count(), 12u);
    const MeshShape soft = mesh_shape(box_mesh(glm::dvec3(1), glm::ivec3(3)), 100);
    EXPECT_TRUE(soft.edges.empty());
    EXPECT_TRUE(soft.closed);
    const MeshShape sheet = mesh_shape(plane_mesh({1, 1}, {2, 2}), 35);
    EXPECT_FALSE(sheet.closed);
    EXPECT_EQ(sheet.edges.size(), 8u);
}

TEST(MeshLines, AreNoneOfAMeshWithoutFaces)
{
    EXPECT_TRUE(shaped_mesh(Mesh{}, {.more = {true, true, true, true, 3}}).shape.points.empty());
}

TEST(MeshLines, OfATeapotAreTheSameForAnyNumberOfThreads)
{
    const Mesh pot = teapot_mesh(1, 12);
    const LineDrawing drawing{.more = {.suggestive = true, .ridges = true, .valleys = true}};
    const auto points = [&] {
        std::vector<glm::vec2> out;
        for (const KindStrokes& each : drawn(pot, drawing, camera_from({3, -4, 2}, true)))
            for (const Stroke& stroke : each.strokes)
                for (const StrokePoint& p : stroke.points) out.push_back(p.at);
        return out;
    };
    const std::vector<glm::vec2> many = points();
    const ThreadLimit one(1);
    EXPECT_EQ(many, points());
    EXPECT_FALSE(many.empty());
}

} // namespace
} // namespace trivar::testing
