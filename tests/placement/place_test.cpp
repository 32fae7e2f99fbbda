// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/placement.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/placement/view.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

RayScene ground()
{
    return scene_of(plane_mesh({20, 20}, {4, 4}));
}

TEST(Place, OnAPlaneTheContactIsPlanarAndEvenlySpread)
{
    const Camera camera = from_above();
    const Placement out = placed(stroke(camera, {{300, 500}, {1200, 560}}), ground());
    const double length = out.report.length_world, width = out.report.width_world;
    // 902 pixels of 2 mm; the snake is a fifth as wide and a tenth as high as long.
    EXPECT_NEAR(length, 0.002 * std::hypot(900, 60), 1e-9);
    EXPECT_NEAR(width, length / 5, 1e-9);
    EXPECT_NEAR(out.report.height_world, length / 10, 1e-9);
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j) {
            const auto s = evaluate(out.contact, {i / 8.0, j / 8.0}, 1);
            EXPECT_NEAR(s.value.z, 0, 1e-12);
            EXPECT_NEAR(glm::length(s.u), length, 1e-9 * length);
            EXPECT_NEAR(glm::length(s.v), width, 1e-9 * width);
        }
}

TEST(Place, RoundARingTheEndsMeet)
{
    std::vector<glm::dvec2> ring;
    for (int i = 0; i <= 72; ++i) {
        const double t = 0.0872665 * i;
        ring.emplace_back(750 + 300 * std::cos(t), 500 + 300 * std::sin(t));
    }
    const Mesh bumpy = height_field(
        4, 60, [](double x, double y) { return 0.1 * std::sin(5 * x) * std::cos(4 * y); });
    const Placement out = placed(stroke(from_above(), ring), scene_of(bumpy),
                                 {.width = 0.2, .height = 0.1, .grid = {48, 8, 3}});
    for (const double v : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto head = evaluate(out.contact, {0, v}, 1), tail = evaluate(out.contact, {1, v}, 1);
        EXPECT_LT(glm::length(head.value - tail.value), 0.02 * out.report.height_world);
        EXPECT_GT(glm::dot(glm::normalize(head.u), glm::normalize(tail.u)), 0.97);
    }
}

TEST(Place, NeverOvershootsUpwardsWithoutSprings)
{
    // A cliff four times as high as a span of the grid is long, in the middle of the stroke.
    const double top = 0.5;
    glm::dmat4 raised(1);
    raised[3] = {0, 0, top / 2, 1};
    const auto mesh = [](Mesh m) {
        return std::make_shared<const RayMesh>(make_ref(std::move(m)));
    };
    const RayScene scene({{mesh(plane_mesh({8, 8}, {2, 2})), glm::dmat4(1), 1},
                          {mesh(box_mesh({0.9, 2, top}, {1, 1, 1})), raised, 2}});
    for (const Camera& camera : {from_above(), from_above(3), from_the_side()}) {
        const Placement out = placed(stroke_over(camera, {{-1, -0.2, 0}, {1.1, 0.1, 0}}), scene,
                                     {.grid = {17, 5, 3}, .springs = false});
        const double allowed = 1e-3 * out.report.height_world;
        EXPECT_LE(out.report.penetration, 1e-3);
        double highest = -1e300;
        for (const glm::dvec3& p : out.contact.points)
            highest = std::max(highest, -glm::dot(p, View(camera).forward()));
        // A corner of the roof is highest toward the camera.
        double roof = -1e300;
        for (const double x : {-0.45, 0.45})
            for (const double y : {-1.0, 1.0})
                roof = std::max(roof, -glm::dot({x, y, top}, View(camera).forward()));
        EXPECT_LE(highest, roof + allowed);
    }
}

TEST(Place, IsDeterministicForAnyNumberOfThreads)
{
    const RayScene scene = scene_of(
        height_field(6, 80, [](double x, double y) { return 0.3 * sin(3 * x) * cos(4 * y); }));
    const Sketch sketch = stroke_over(from_the_side(), {{-1, 0, 0}, {0, 0.3, 0}, {1, 0, 0}});
    const auto with_threads = [&](int n) {
        const ThreadLimit limit(n);
        return placed(sketch, scene, {.offset = 0.5});
    };
    const Placement one = with_threads(1), two = with_threads(2);
    EXPECT_EQ(one.contact, two.contact);
    EXPECT_EQ(one.volume, two.volume);
    EXPECT_EQ(one.embedding, two.embedding);
}

TEST(Place, NeverMirrorsTheModel)
{
    for (const bool reverse : {false, true})
        for (const double roll : {0.0, 90.0, 180.0, 270.0}) {
            const Placement out = placed(stroke(from_above(), {{300, 500}, {1200, 500}}), ground(),
                                         {.reverse = reverse, .roll_deg = roll});
            const glm::dmat3 to_uvw(out.embedding.to_uvw);
            const auto jet = evaluate(out.volume, {0.5, 0.5, 0.5}, 1);
            const glm::dmat3 j(jet.first[0], jet.first[1], jet.first[2]);
            EXPECT_GT(glm::determinant(j * to_uvw), 0);
            EXPECT_GT(out.report.smallest_jacobian, 0.99);
        }
}

TEST(Place, KeepsTheProportionsOfTheModel)
{
    const Placement out = placed(stroke(from_above(), {{300, 500}, {1200, 500}}), ground(),
                                 {.start = 0.25, .fill = 0.5});
    const auto jet = evaluate(out.volume, {0.5, 0.5, 0.5}, 1);
    const glm::dmat3 j =
        glm::dmat3(jet.first[0], jet.first[1], jet.first[2]) * glm::dmat3(out.embedding.to_uvw);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(glm::length(j[axis]), 1.8 * 0.5 / 10, 1e-9);
    EXPECT_NEAR((out.embedding.to_uvw * glm::dvec4(-5, 0, 0, 1)).x, 0.25, 1e-12);
    EXPECT_NEAR((out.embedding.to_uvw * glm::dvec4(5, 0, 1, 1)).x, 0.75, 1e-12);
    EXPECT_NEAR((out.embedding.to_uvw * glm::dvec4(5, 0, 1, 1)).z, 1, 1e-12);
}

} // namespace
} // namespace trivar
