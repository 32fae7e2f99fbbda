// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/geodesic.h"

#include "core/limit/tangent.h"
#include "tests/limit/cages.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

TEST(Geodesics, AreStraightInAPlaneAndEndWhereTheyShould)
{
    const LimitSurface plane = limit_of(plane_cage());
    std::mt19937 random(1);
    for (int k = 0; k < 300; ++k) {
        const ChartPlace at = random_chart_place(plane, random);
        const glm::dvec3 way = 0.4 * random_tangent_at(plane, at, random);
        const GeodesicRay ray = geodesic(plane, at, way, 4);
        const glm::dvec3 end = plane.position(ray.at) + ray.left * ray.direction;
        EXPECT_LT(glm::distance(end, plane.position(at) + way), 1e-7);
        const double out = std::max(std::abs(end.x), std::abs(end.y));
        EXPECT_EQ(ray.left > 1e-6, out > 1 + 1e-6);
    }
}

// A way of length r over the unit sphere ends at the angle r.
TEST(Geodesics, OverASphereAreGreatCircles)
{
    const LimitSurface& sphere = limit_sphere();
    std::mt19937 random(2);
    int far_off = 0; // over vertices of valence 3, where the surface is only nearly the sphere
    for (int k = 0; k < 400; ++k) {
        const ChartPlace at = random_chart_place(sphere, random);
        const glm::dvec3 p = glm::normalize(sphere.position(at));
        const glm::dvec3 t = in_tangent_plane(random_tangent_at(sphere, at, random), p);
        for (const double r : {0.3, 1.0}) {
            const GeodesicRay ray = geodesic(sphere, at, r * t, steps_from(sphere, at, r));
            EXPECT_EQ(ray.left, 0);
            const glm::dvec3 truth = std::cos(r) * p + std::sin(r) * t;
            const double off = glm::distance(sphere.position(ray.at), truth) / r;
            EXPECT_LT(off, 3e-3);
            far_off += off > 1e-3;
            EXPECT_NEAR(ray.spread, std::sin(r), 0.01 * r);
        }
    }
    EXPECT_LE(far_off, 8) << "of 800";
}

TEST(Geodesics, ComeBackByTheWayTheyWent)
{
    std::mt19937 random(3);
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitSurface surface = limit_of(cage.mesh);
        for (int k = 0; k < 100; ++k) {
            const ChartPlace at = random_chart_place(surface, random);
            const glm::dvec3 way = 0.2 * random_tangent_at(surface, at, random);
            const GeodesicRay there = geodesic(surface, at, way, 16);
            if (there.left > 0) continue;
            const GeodesicRay back = geodesic(surface, there.at, -0.2 * there.direction, 16);
            EXPECT_LT(glm::distance(surface.position(back.at), surface.position(at)), 2e-3);
        }
    }
}

// Steps near extraordinary vertices lose nothing: few steps end where many do.
TEST(Geodesics, OverExtraordinaryVerticesAreAsGoodAsElsewhere)
{
    std::mt19937 random(4);
    for (const Mesh& mesh : {cube_cage(), tower_cage()}) {
        const LimitSurface surface = limit_of(mesh);
        for (std::uint32_t c = 0; c < surface.net().size(); ++c) {
            const ChartPlace at{c, {0.11, 0.07}};
            const glm::dvec3 way = 0.15 * random_tangent_at(surface, at, random);
            const glm::dvec3 few = surface.position(geodesic(surface, at, way, 8).at),
                             many = surface.position(geodesic(surface, at, way, 64).at);
            EXPECT_LT(glm::distance(few, many), 2e-3 * 0.15);
        }
    }
}

TEST(Geodesics, GoOverCreasesAsIfTheyWereUnfolded)
{
    const LimitSurface box = limit_of(sharp_box_cage());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-0.4, 0.4);
    int crossed = 0;
    for (int k = 0; k < 400; ++k) {
        const ChartPlace at = random_chart_place(box, random);
        const glm::dvec3 p = box.position(at), n = box.normal(at);
        const glm::dvec3 t = random_tangent_at(box, at, random);
        constexpr double length = 0.4;
        const GeodesicRay ray = geodesic(box, at, length * t, 4);
        EXPECT_EQ(ray.left, 0);
        // The first face that the way leaves, through the side where a coordinate is 1 or -1.
        const glm::dvec3 flat = p + length * t;
        int over = 0, axis = 0;
        for (int a = 0; a < 3; ++a)
            if (std::abs(n[a]) < 0.5 && std::abs(flat[a]) > 1) ++over, axis = a;
        if (over == 2) continue; // round a corner
        glm::dvec3 truth = flat;
        if (over == 1) {
            const double beyond = std::abs(flat[axis]) - 1;
            truth[axis] = std::copysign(1.0, flat[axis]);
            truth -= beyond * n;
            ++crossed;
        }
        EXPECT_LT(glm::distance(box.position(ray.at), truth), 1e-6);
        EXPECT_EQ(ray.creases, over);
    }
    EXPECT_GT(crossed, 50);
}

TEST(Geodesics, EndForAnyNumbers)
{
    for (const NamedCage& cage : all_cages()) {
        const LimitSurface surface = limit_of(cage.mesh);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        geodesic(surface, {0, glm::dvec2(0.5)}, glm::dvec3(nan), 2);
        geodesic(surface, {0, glm::dvec2(0.5)}, glm::dvec3(1e6), 2);
    }
}

TEST(FootPoints, AreWhereTheNormalMeetsAPoint)
{
    std::mt19937 random(6);
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitSurface surface = limit_of(cage.mesh);
        for (int k = 0; k < 200; ++k) {
            const ChartPlace at = random_chart_place(surface, random);
            ChartPlace near = at;
            near.uv = glm::clamp(near.uv + 0.03, 0.0, 1.0);
            const glm::dvec3 p = surface.position(at) + 0.01 * surface.normal(at);
            const FootPoint foot = foot_point(surface, near, p, 1e-9);
            EXPECT_LT(glm::distance(surface.position(foot.at), surface.position(at)), 1e-6);
        }
    }
}

} // namespace
} // namespace trivar::testing
