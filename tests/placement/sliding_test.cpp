// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sliding.h"

#include "core/mesh/primitives.h"
#include "tests/placement/scenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

glm::dvec3 at(const glm::dmat4& by, const glm::dvec3& p)
{
    return glm::dvec3(by * glm::dvec4(p, 1));
}
glm::dvec3 turned(const glm::dmat4& by, const glm::dvec3& v)
{
    return glm::dmat3(by) * v;
}

RayScene level()
{
    return scene_of(plane_mesh({40, 40}, {1, 1}));
}
RayScene ball()
{
    return scene_of(sphere_mesh(1, 256, 128));
}

// The largest distance of one contact surface from another that was moved.
double apart(const Placement& a, const glm::dmat4& by, const Placement& b)
{
    double worst = 0;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 4; ++j) {
            const glm::dvec2 uv(i / 20.0, j / 4.0);
            worst = std::max(worst, glm::distance(at(by, evaluate(a.contact, uv).value),
                                                  evaluate(b.contact, uv).value));
        }
    return worst;
}

TEST(Sliding, OnLevelGroundTheLaidVolumeMovesAsAWhole)
{
    const RayScene floor = level();
    const Sketch sketch = stroke_over(from_the_side(), {{-0.8, 0, 0}, {0, 0.3, 0}, {0.8, 0, 0}});
    const Placement before = placed(sketch, floor);
    const Ground middle{{0, 0.2, 0}, {0, 0, 1}};
    const glm::dmat4 shift = slid(middle, {{2.5, -1, 0}, {0, 0, 1}});
    for (const glm::dmat4& by : {shift, turned_on(middle, 77), turned_on(middle, -160),
                                 grown_on(middle, 1.7), grown_on(middle, 0.3)}) {
        const Sketch after = moved_stroke(sketch, by, floor, floor, middle);
        EXPECT_EQ(after.samples, sketch.samples);
        EXPECT_LT(apart(before, by, placed(after, floor)), 1e-7);
    }
    EXPECT_EQ(turned_on(middle, 0), glm::dmat4(1));
    EXPECT_EQ(slid(middle, middle), glm::dmat4(1));
}

TEST(Sliding, TakesThePlaceAndTheNormalToThoseWanted)
{
    const RayScene sphere = ball();
    const auto from = ground_hit(sphere, {{0, -5, 0.2}, {0, 1, 0}}, 0.2);
    ASSERT_TRUE(from);
    EXPECT_NEAR(glm::dot(from->normal, glm::normalize(from->p)), 1, 1e-4);
    for (const glm::dvec3& eye : {glm::dvec3(5, 0, 0.3), {0, 0, 5}, {3, 3, -3}, {-0.1, 5, 0}}) {
        const auto to = ground_hit(sphere, {eye, -glm::normalize(eye)}, 0.2);
        ASSERT_TRUE(to);
        const glm::dmat4 by = slid(*from, *to);
        EXPECT_LT(glm::distance(at(by, from->p), to->p), 1e-9);
        EXPECT_LT(glm::distance(turned(by, from->normal), to->normal), 1e-9);
        EXPECT_NEAR(glm::determinant(glm::dmat3(by)), 1, 1e-9) << "nothing grows";
    }
}

TEST(Sliding, WhatStandsUprightOnAWallStaysUpright)
{
    const auto on_ball = [](double round, double up) {
        const glm::dvec3 n(std::cos(up) * std::cos(round), std::cos(up) * std::sin(round),
                           std::sin(up));
        return Ground{n, n};
    };
    const Ground from = on_ball(0, 0.2);
    const glm::dvec3 up = glm::normalize(glm::dvec3(0, 0, 1) - from.normal * from.normal.z);
    for (const double round : {0.5, 1.5, 2.5, 3.1, -2.0})
        for (const double height : {-0.6, 0.0, 0.5}) {
            const Ground to = on_ball(round, height);
            const glm::dvec3 now = turned(slid(from, to), up);
            EXPECT_NEAR(glm::dot(now, glm::cross(to.normal, glm::dvec3(0, 0, 1))), 0, 1e-9);
            EXPECT_GT(now.z, 0);
        }
}

TEST(Sliding, AWalkIsAsLongAsAskedForAndComesRoundABall)
{
    const RayScene sphere = ball();
    const Ground from{{1, 0, 0}, {1, 0, 0}};
    for (const double distance : {0.3, -0.3, 1.5, glm::two_pi<double>()}) {
        const Ground to = walked(sphere, from, {0, 1, 0}, distance, 0.2);
        EXPECT_LT(glm::distance(to.p, {std::cos(distance), std::sin(distance), 0}), 0.02)
            << distance;
    }
    const RayScene floor = level();
    const Ground flat = walked(floor, {{1, 2, 0}, {0, 0, 1}}, {3, 4, 0}, 2.5, 0.3);
    EXPECT_LT(glm::distance(flat.p, {2.5, 4, 0}), 1e-9);
    const Ground beyond = walked(floor, {{19, 0, 0}, {0, 0, 1}}, {1, 0, 0}, 5, 0.3);
    EXPECT_LT(glm::distance(beyond.p, {24, 0, 0}), 1e-9) << "beyond the scene it goes on";
}

TEST(Sliding, TheMeanNormalDoesNotJumpFromFaceToFace)
{
    const RayScene coarse = scene_of(sphere_mesh(1, 16, 8));
    const auto normal = [&](double round) {
        const glm::dvec3 out(std::cos(round), std::sin(round), 0.1);
        return ground_hit(coarse, {out * 5.0, -glm::normalize(out)}, 0.5)->normal;
    };
    const double between_faces = glm::two_pi<double>() / 16;
    for (double round = 0; round < 1; round += 0.02)
        EXPECT_LT(std::acos(std::min(1.0, glm::dot(normal(round), normal(round + 0.02)))),
                  between_faces / 3)
            << round;
}

TEST(Sliding, AStrokeThatWouldBeHiddenIsSeenFromCloseAbove)
{
    // A wall stands where the camera would look through it.
    glm::dmat4 stands(1);
    stands[3] = {3, -1.5, 1, 1};
    const RayScene scene(
        {{std::make_shared<const RayMesh>(make_ref(plane_mesh({40, 40}, {1, 1}))), glm::dmat4(1),
          1},
         {std::make_shared<const RayMesh>(make_ref(box_mesh({3, 0.1, 4}, {1, 1, 1}))), stands, 2}});
    const Sketch sketch =
        stroke_over(from_the_side({0, -5, 2}), {{-0.8, 0, 0}, {0, 0.3, 0}, {0.8, 0, 0}});
    const Ground middle{{0, 0.2, 0}, {0, 0, 1}}, there{{3, 0.2, 0}, {0, 0, 1}};
    const glm::dmat4 by = slid(middle, there);
    const Sketch after = moved_stroke(sketch, by, scene, scene, there);
    EXPECT_FALSE(after.camera.perspective);
    ASSERT_EQ(after.samples.size(), sketch.samples.size());
    const Placement before = placed(sketch, scene), now = placed(after, scene);
    // The same place, seen from elsewhere: the width is taken at another depth.
    for (const double u : {0.0, 0.3, 0.7, 1.0})
        EXPECT_LT(glm::distance(at(by, evaluate(before.contact, {u, 0.5}).value),
                                evaluate(now.contact, {u, 0.5}).value),
                  0.02);
}

} // namespace
} // namespace trivar
