// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/shape_lines.h"

#include "core/base/parallel.h"
#include "core/lines/mesh_shape.h"
#include "core/lines/zero_lines.h"
#include "core/mesh/primitives.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace trivar::testing {
namespace {

// A ball of radius 1 stretched along the axes, without edges at its poles.
SurfaceShape ellipsoid(const glm::vec3& axes, int n)
{
    Mesh mesh = box_mesh(glm::dvec3(2), glm::ivec3(n));
    mesh.normals.clear();
    for (glm::vec3& p : mesh.positions) {
        const glm::vec3 angle = p * 0.78539816f, t = glm::tan(angle); // equal angles
        p = glm::normalize(t);
        mesh.normals.push_back(glm::normalize(p / axes));
        p *= axes;
    }
    return mesh_shape(mesh, 90).surface;
}

Silhouettes lines_of(const SurfaceShape& shape, LineKind kind, const MoreLines& wanted)
{
    for (const KindLines& each : fixed_lines(shape, wanted))
        if (each.kind == kind) return each.lines;
    return {};
}

void expect_no_branch(const Silhouettes& lines)
{
    std::set<std::uint64_t> edges;
    for (const SilhouettePoint& point : lines.points)
        EXPECT_TRUE(edges.insert(point.edge).second) << "an edge is in two lines";
}

TEST(ZeroLines, OfAPlaneThroughABallAreOneLoopOnIt)
{
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 24);
    std::vector<float> height;
    for (const glm::vec3& p : ball.positions) height.push_back(p.z + 0.1f * p.x - 0.2f);
    const Silhouettes lines =
        zero_lines(ball, {height, {}, [](auto...) { return 1.0f; }}, {.strong = 0.5f});
    ASSERT_EQ(lines.count(), 1u);
    EXPECT_TRUE(lines.closed[0]);
    for (const SilhouettePoint& point : lines.points)
        EXPECT_NEAR(point.p.z + 0.1f * point.p.x, 0.2f, 1e-6);
    expect_no_branch(lines);
}

TEST(ZeroLines, GoOnWhereTheyAreWeakIfTheyAreStrongSomewhere)
{
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 24);
    std::vector<float> height;
    for (const glm::vec3& p : ball.positions) height.push_back(p.z + 0.01f);
    // Strong on one side, weak on the other, and nothing in a gap.
    const auto strength = [&](std::size_t t, const auto&) {
        const glm::vec3& p = ball.positions[ball.corners[3 * t]];
        return std::abs(p.y) < 0.3f && p.x < 0 ? 0.0f : p.x > 0 ? 1.0f : 0.5f;
    };
    const Silhouettes lines =
        zero_lines(ball, {height, {}, strength}, {.weak = 0.4f, .strong = 0.8f, .smoothing = 0});
    ASSERT_EQ(lines.count(), 1u);
    EXPECT_FALSE(lines.closed[0]);
    EXPECT_LT(lines.points.front().p.x, -0.9f);
    EXPECT_LT(lines.points.back().p.x, -0.9f);
    EXPECT_EQ(zero_lines(ball, {height, {}, strength}, {.weak = 0.4f, .strong = 2}).count(), 0u);
}

TEST(ZeroLines, TurnTheirSignsWithDirections)
{
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 24);
    std::vector<float> values;
    std::vector<glm::vec3> directions;
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const float sign = i % 3 == 0 ? -1.0f : 1.0f;
        values.push_back(sign * (ball.positions[i].z - 0.03f));
        directions.emplace_back(0, 0, sign);
    }
    const Silhouettes lines =
        zero_lines(ball, {values, directions, [](auto...) { return 1.0f; }}, {.strong = 0.5f});
    ASSERT_EQ(lines.count(), 1u);
    EXPECT_TRUE(lines.closed[0]);
    for (const SilhouettePoint& point : lines.points) EXPECT_NEAR(point.p.z, 0.03, 1e-5);
}

TEST(Ridges, OfAFlatEllipsoidAreItsRim)
{
    const SurfaceShape lens = ellipsoid({2, 2, 0.4f}, 48);
    const Silhouettes lines = lines_of(lens, LineKind::ridges, {.ridges = true, .detail = 4});
    ASSERT_GE(lines.count(), 1u);
    double length = 0;
    for (std::size_t c = 0; c < lines.count(); ++c)
        for (std::uint32_t i = lines.first[c] + 1; i < lines.first[c + 1]; ++i)
            length += glm::distance(lines.points[i].p, lines.points[i - 1].p);
    EXPECT_GE(length, 0.9 * 4 * 3.14159);
    for (const SilhouettePoint& point : lines.points) {
        EXPECT_NEAR(point.p.z, 0, 0.02);
        EXPECT_NEAR(std::hypot(point.p.x, point.p.y), 2, 0.02);
    }
    expect_no_branch(lines);
    EXPECT_TRUE(lines_of(lens, LineKind::valleys, {.valleys = true, .detail = 4}).points.empty());
}

TEST(ParabolicLines, OfARingAreWhereItTouchesTwoPlanes)
{
    const SurfaceShape ring = mesh_shape(torus_mesh(3, 1, {160, 80}), 60).surface;
    const Silhouettes lines = lines_of(ring, LineKind::parabolic, {.parabolic = true, .detail = 4});
    ASSERT_EQ(lines.count(), 2u);
    for (const SilhouettePoint& point : lines.points) {
        EXPECT_NEAR(std::abs(point.p.z), 1, 0.01);
        EXPECT_NEAR(std::hypot(point.p.x, point.p.y), 3, 0.05);
    }
    EXPECT_TRUE(lines.closed[0] && lines.closed[1]);
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 24);
    EXPECT_TRUE(
        lines_of(ball, LineKind::parabolic, {.parabolic = true, .detail = 4}).points.empty());
}

TEST(Isophotes, OfABallAreCirclesRoundTheLight)
{
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 32);
    const glm::vec3 light = glm::normalize(glm::vec3(1, -2, 3));
    const Silhouettes lines =
        lines_of(ball, LineKind::isophotes, {.isophotes = 4, .light = 5.0f * light});
    ASSERT_EQ(lines.count(), 4u);
    for (std::size_t c = 0; c < 4; ++c)
        for (std::uint32_t i = lines.first[c]; i < lines.first[c + 1]; ++i)
            EXPECT_NEAR(glm::dot(lines.points[i].p, light), static_cast<double>(c) / 4, 0.003);
}

TEST(SuggestiveContours, AreWhereTheCurvatureAlongTheSightVanishes)
{
    const SurfaceShape ring = mesh_shape(torus_mesh(3, 1, {240, 120}), 60).surface;
    const ViewPoint view{{0.3, 0.9, -0.5, 0}};
    const Silhouettes lines = suggestive_lines(ring, view, {.suggestive = true, .detail = 20});
    ASSERT_GE(lines.count(), 1u);
    for (const SilhouettePoint& point : lines.points) {
        // The curvatures of the ring are 1 along its tube and cos / (3 + cos) round it.
        const float out = std::hypot(point.p.x, point.p.y), cosine = out - 3;
        const glm::vec3 round(-point.p.y / out, point.p.x / out, 0),
            n(point.p.x / out * cosine, point.p.y / out * cosine, point.p.z),
            along = glm::cross(glm::normalize(n), round),
            eye = -glm::normalize(glm::vec3(glm::dvec3(view.at)));
        const float a = glm::dot(eye, round), b = glm::dot(eye, along);
        EXPECT_NEAR((a * a * cosine / out + b * b) / (a * a + b * b), 0, 0.02);
        EXPECT_GE(glm::dot(glm::normalize(n), eye), 0.0f);
    }
    const SurfaceShape ball = ellipsoid(glm::vec3(1), 24);
    EXPECT_TRUE(suggestive_lines(ball, view, {.detail = 20}).points.empty());
}

TEST(FurtherLines, AreTheSameForAnyNumberOfThreads)
{
    const SurfaceShape ring = mesh_shape(torus_mesh(3, 1, {200, 100}), 60).surface;
    const MoreLines all{true, true, true, true, 3};
    const auto found = [&] {
        std::vector<glm::vec3> out;
        for (const KindLines& each : fixed_lines(ring, all))
            for (const SilhouettePoint& point : each.lines.points) out.push_back(point.p);
        for (const SilhouettePoint& p : suggestive_lines(ring, {{1, 2, 3, 1}}, all).points)
            out.push_back(p.p);
        return out;
    };
    const std::vector<glm::vec3> many = found();
    const ThreadLimit one(1);
    EXPECT_EQ(many, found());
    EXPECT_FALSE(many.empty());
}

} // namespace
} // namespace trivar::testing
