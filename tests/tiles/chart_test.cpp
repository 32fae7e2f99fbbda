// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/tiles/straightest.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

Tile tile_at(const SurfacePlace& at, const glm::dvec3& x, double size)
{
    return {at, x, size};
}

TEST(TilePatches, GoThroughTheirNodes)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int k = 0; k < 100; ++k) {
        std::array<glm::dvec3, 16> p, n;
        for (glm::dvec3& v : p) v = {number(random), number(random), number(random)};
        for (glm::dvec3& v : n) v = {number(random), number(random), number(random)};
        const TilePatch patch{through_nodes(p), through_nodes(n)};
        for (std::size_t i = 0; i < 16; ++i) {
            const TilePoint t = tile_point(patch, {patch_nodes[i % 4], patch_nodes[i / 4], 0.3});
            EXPECT_LT(glm::distance(t.p, p[i] + 0.3 * n[i]), 1e-13);
            EXPECT_LT(glm::distance(t.z, n[i]), 1e-13);
        }
    }
}

TEST(TilePatches, HaveTheDerivativesOfTheirPoints)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1, 1);
    TilePatch patch;
    for (glm::dvec3& v : patch.p) v = {number(random), number(random), number(random)};
    for (glm::dvec3& v : patch.n) v = {number(random), number(random), number(random)};
    for (int k = 0; k < 100; ++k) {
        const glm::dvec3 at{number(random), number(random), number(random)};
        const double h = 1e-5;
        const auto slope = [&](const glm::dvec3& d) {
            return (tile_point(patch, at + h * d).p - tile_point(patch, at - h * d).p) / (2 * h);
        };
        const TilePoint t = tile_point(patch, at);
        EXPECT_LT(glm::distance(t.x, slope({1, 0, 0})), 1e-6);
        EXPECT_LT(glm::distance(t.y, slope({0, 1, 0})), 1e-6);
        EXPECT_LT(glm::distance(t.z, slope({0, 0, 1})), 1e-6);
    }
}

TEST(StraightestWays, AreStraightInAPlaneAndEndWhereTheyShould)
{
    const TileBase base = base_of(plane_mesh({2, 2}, {13, 7}));
    std::mt19937 random(3);
    for (int k = 0; k < 500; ++k) {
        const SurfacePlace at = random_place(base, random);
        const glm::dvec3 way = 0.3 * random_tangent(base, at, random);
        const SurfaceRay ray = straightest(base, at, way);
        const glm::dvec3 end = base.position(ray.at) + ray.left * ray.direction;
        EXPECT_LT(glm::distance(end, base.position(at) + way), 1e-12);
        EXPECT_EQ(ray.left > 0, std::max(std::abs(end.x), std::abs(end.y)) > 1)
            << end.x << " " << end.y;
    }
}

TEST(StraightestWays, GoOverTheEdgeOfABoxAsIfItWereUnfolded)
{
    const TileBase base = base_of(box_mesh({2, 2, 2}, {6, 6, 6}));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-0.5, 0.5);
    for (int k = 0; k < 200; ++k) { // from the top over the edge at x = 1 down its side
        const glm::dvec3 from{0.9, number(random), 1};
        const std::vector<SurfacePoint> top{{from, {0, 0, 1}}};
        const SurfacePlace at = *base.locate(top, 0.1).front();
        const double slope = number(random);
        const glm::dvec3 way = 0.4 * glm::normalize(glm::dvec3(1, slope, 0));
        const SurfaceRay ray =
            straightest(base, at, turned_from_to(glm::dvec3(0, 0, 1), base.normal(at), way));
        EXPECT_EQ(ray.left, 0);
        const glm::dvec3 flat = from + way, truth{1, flat.y, 1 - (flat.x - 1)};
        EXPECT_LT(glm::distance(base.position(ray.at), truth), 1e-6);
    }
}

TEST(StraightestWays, ComeBackByTheWayTheyWent)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {61, 23}));
    std::mt19937 random(5);
    for (int k = 0; k < 300; ++k) {
        const SurfacePlace at = random_place(base, random);
        const SurfaceRay there = straightest(base, at, 0.7 * random_tangent(base, at, random));
        ASSERT_EQ(there.left, 0);
        // The direction lies in the triangle; a way begins in the plane of the smooth normal.
        const glm::dvec3 back = turned_from_to(base.face_normal(there.at.triangle),
                                               base.normal(there.at), -there.direction);
        const SurfaceRay home = straightest(base, there.at, 0.7 * back);
        EXPECT_LT(glm::distance(base.position(home.at), base.position(at)), 1e-8);
    }
}

TEST(TileCharts, AreTheTileItselfOnAPlane)
{
    const TileBase base = base_of(plane_mesh({4, 4}, {9, 5}));
    const BasePose pose = at_rest(base);
    std::mt19937 random(6);
    for (int k = 0; k < 200; ++k) {
        const SurfacePlace at = random_place(base, random);
        const glm::dvec3 p = base.position(at), x = random_tangent(base, at, random);
        if (std::max(std::abs(p.x), std::abs(p.y)) > 1.2) continue;
        const TileChart chart = chart_of(base, tile_at(at, x, 0.8), 0, 1);
        EXPECT_EQ(chart.cut, 0);
        const TilePatch patch = patch_of(base, pose, chart);
        const glm::dvec3 y = glm::cross(glm::dvec3(0, 0, 1), x);
        for (const glm::dvec3 q : {glm::dvec3(0.1, 0.7, 0.2), {0.9, 0.35, -0.1}, {0.5, 0.5, 1}})
            EXPECT_LT(glm::distance(tile_point(patch, q).p,
                                    p + 0.8 * ((q.x - 0.5) * x + (q.y - 0.5) * y) +
                                        glm::dvec3(0, 0, q.z)),
                      1e-6); // positions of meshes are in single precision
    }
}

TEST(TileCharts, GoOnStraightBeyondABorderAndSayHowFar)
{
    const TileBase base = base_of(plane_mesh({2, 2}, {8, 8}));
    const std::vector<SurfacePoint> near_border{{{0.9, 0.1, 0}, {0, 0, 1}}};
    const SurfacePlace at = *base.locate(near_border, 0.1).front();
    const TileChart chart = chart_of(base, tile_at(at, {1, 0, 0}, 0.4), 0, 1);
    EXPECT_NEAR(chart.cut, 0.25 * std::sqrt(2), 1e-6); // of the ways to both corners
    const TilePatch patch = patch_of(base, at_rest(base), chart);
    EXPECT_LT(glm::distance(tile_point(patch, {1, 0.5, 0}).p, {1.1, 0.1, 0}), 1e-6);
}

TEST(TileCharts, OfATileThatIsLargerThanTheBaseAreNone)
{
    const TileBase base = base_of(sphere_mesh(1, 24, 12));
    const SurfacePlace at{};
    EXPECT_GT(chart_of(base, tile_at(at, {1, 0, 0}, 1e9), 0, 1).cut, 1e100);
    EXPECT_GT(chart_of(base, tile_at(at, {1, 0, 0}, 1), 0, 1e9).cut, 1e100);
}

// The exponential map of a sphere is known: a way of length r ends at the angle r / R.
TEST(TileCharts, AreTheExponentialMapOfASphere)
{
    const TileBase base = base_of(sphere_mesh(1, 256, 128));
    const BasePose pose = at_rest(base);
    std::mt19937 random(7);
    for (int k = 0; k < 100; ++k) {
        const SurfacePlace at = random_place(base, random);
        const glm::dvec3 c = glm::normalize(base.position(at));
        const glm::dvec3 x = random_tangent(base, at, random);
        const double size = 0.5; // the corners are 0.35 away
        const TilePatch patch = patch_of(base, pose, chart_of(base, tile_at(at, x, size), 0, 1));
        const glm::dvec3 ex = glm::normalize(x - glm::dot(x, c) * c), ey = glm::cross(c, ex);
        for (int i = 0; i < 25; ++i) {
            const glm::dvec2 q{(i % 5) / 4.0, (i / 5) / 4.0};
            const glm::dvec2 d = size * (q - 0.5);
            const double r = glm::length(d);
            const glm::dvec3 way = r > 0 ? (d.x * ex + d.y * ey) / r : glm::dvec3(0);
            const glm::dvec3 truth = std::cos(r) * c + std::sin(r) * way;
            EXPECT_LT(glm::distance(tile_point(patch, {q, 0}).p, truth), 2e-3);
            const glm::dvec3 high = tile_point(patch, {q, 0.2}).p;
            EXPECT_NEAR(glm::length(high), 1.2, 1e-3);
        }
    }
}

TEST(TileCharts, RideAlongWithAMovedBase)
{
    const TileBase base = base_of(sphere_mesh(1, 64, 32));
    BasePose pose = at_rest(base);
    std::mt19937 random(8);
    std::vector<TileChart> charts;
    for (int k = 0; k < 20; ++k) {
        const SurfacePlace at = random_place(base, random);
        charts.push_back(
            chart_of(base, tile_at(at, random_tangent(base, at, random), 0.3), 30, 0.5));
    }
    std::vector<TilePatch> before;
    for (const TileChart& chart : charts) before.push_back(patch_of(base, pose, chart));
    const glm::dmat3 turned(0, 1, 0, -1, 0, 0, 0, 0, 1);
    for (glm::dvec3& p : pose.points) p = turned * p + glm::dvec3(3, 4, 5);
    for (glm::dvec3& n : pose.normals) n = turned * n;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const TilePatch after = patch_of(base, pose, charts[i]);
        for (std::size_t k = 0; k < 16; ++k) {
            EXPECT_LT(glm::distance(after.p[k], turned * before[i].p[k] + glm::dvec3(3, 4, 5)),
                      1e-12);
            EXPECT_LT(glm::distance(after.n[k], turned * before[i].n[k]), 1e-12);
        }
    }
}

} // namespace
} // namespace trivar
