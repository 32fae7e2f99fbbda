// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/placement/placement.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using namespace ::testing;

glm::dmat4 moved(glm::dvec3 by)
{
    glm::dmat4 m(1);
    m[3] = glm::dvec4(by, 1);
    return m;
}

Ref<RayMesh> shared(Mesh mesh)
{
    return std::make_shared<const RayMesh>(make_ref(std::move(mesh)));
}

TEST(Contact, OverACylinderConvergesWithTheFourthPowerOfTheSpacing)
{
    // Along y, of radius 1; so fine that its facets do not show in the differences.
    const double angle = std::acos(-1.0) / 2;
    glm::dmat4 lying(1);
    lying[1] = {0, std::cos(angle), std::sin(angle), 0};
    lying[2] = {0, -std::sin(angle), std::cos(angle), 0};
    const RayScene scene = scene_of(cylinder_mesh(1, 4, 2000, 1), lying);
    const Camera camera = from_above();
    const auto error = [&](int along) {
        const Placement out = placed(
            stroke_over(camera, {{-0.7, 0, 1}, {0.7, 0.1, 1}}), scene,
            {.grid = {along, 5, 4}, .orders = {4, 4, 3}, .springs = false, .lift_tolerance = 1});
        double worst = 0;
        for (int i = 0; i <= 512; ++i) {
            const glm::dvec3 p = evaluate(out.contact, {i / 512.0, 0.5}).value;
            worst = std::max(worst, std::abs(std::hypot(p.x, p.z) - 1));
        }
        return worst;
    };
    const double coarse = error(7), fine = error(13);
    EXPECT_LT(coarse, 1e-2);
    EXPECT_LT(fine, coarse / 10);
}

TEST(Volume, OfF1OverARampRisesTowardTheCamera)
{
    const RayScene scene =
        scene_of(height_field(4, 4, [](double x, double y) { return 0.3 * x - 0.2 * y; }));
    const Placement out =
        placed(stroke(from_above(), {{300, 500}, {1200, 450}}), scene, {.height = 0.25});
    for (const double u : {0.0, 0.3, 1.0})
        for (const double v : {0.0, 0.6, 1.0}) {
            const glm::dvec3 foot = evaluate(out.volume, {u, v, 0}).value;
            const glm::dvec3 roof = evaluate(out.volume, {u, v, 1}).value;
            EXPECT_NEAR(foot.z, 0.3 * foot.x - 0.2 * foot.y, 1e-6);
            EXPECT_LT(glm::distance(roof - foot, {0, 0, 0.25}), 1e-9);
        }
}

TEST(SkipBackFaces, PlacesBehindWhatIsTurnedAway)
{
    glm::dmat4 turned = moved({0, 0, 0.3});
    turned[1] *= -1;
    turned[2] *= -1;
    const RayScene scene({{shared(plane_mesh({20, 20}, {1, 1})), glm::dmat4(1), 1},
                          {shared(plane_mesh({20, 20}, {1, 1})), turned, 2}});
    const Sketch sketch = stroke(from_above(), {{300, 500}, {1200, 560}});
    for (const bool skip : {false, true}) {
        const Placement out = placed(sketch, scene, {.skip_back_faces = skip});
        EXPECT_NEAR(evaluate(out.contact, {0.5, 0.5}).value.z, skip ? 0 : 0.3, 1e-9);
    }
}

TEST(Misses, AreBridgedAsAskedFor)
{
    // Two tables, one higher, and nothing between them.
    const RayScene scene({{shared(plane_mesh({1, 2}, {1, 1})), moved({-0.8, 0, 0.2}), 1},
                          {shared(plane_mesh({1, 2}, {1, 1})), moved({0.8, 0, 0.4}), 2}});
    const Sketch sketch = stroke(from_above(), {{200, 500}, {1300, 500}});
    const auto heights = [&](Misses misses) {
        const Placement out = placed(sketch, scene, {.springs = false, .misses = misses});
        EXPECT_GT(out.report.missed_share, 0);
        double lowest = 1e300, highest = -1e300;
        for (const glm::dvec3& p : out.contact.points) {
            lowest = std::min(lowest, p.z);
            highest = std::max(highest, p.z);
        }
        return std::array{lowest, highest};
    };
    for (const Misses misses : {Misses::membrane, Misses::nearest}) {
        // Control points of a smooth surface stand out a little over a bend.
        EXPECT_NEAR(heights(misses)[0], 0.2, 0.03);
        EXPECT_NEAR(heights(misses)[1], 0.4, 0.03);
    }
    EXPECT_NEAR(heights(Misses::ground)[0], 0, 0.03);
}

TEST(Misses, AreLeftOutWhereTheStrokeShrinks)
{
    const RayScene scene = scene_of(plane_mesh({1, 2}, {1, 1}));
    const Sketch sketch = stroke(from_above(), {{300, 500}, {1200, 500}}); // from -0.9 to 0.9
    const Placement out = placed(sketch, scene, {.misses = Misses::shrink});
    EXPECT_NEAR(out.report.length_world, 1, 0.1);
    EXPECT_LE(out.report.missed_share, 0.1);
}

TEST(Bending, RoundsTheFoldOverAWall)
{
    const RayScene scene({{shared(plane_mesh({8, 8}, {2, 2})), glm::dmat4(1), 1},
                          {shared(box_mesh({0.01, 2, 0.2}, {1, 1, 1})), moved({0, 0, 0.1}), 2}});
    const Sketch sketch = stroke(from_above(3), {{300, 500}, {1200, 500}});
    const auto sharpest = [&](double bending) {
        const Placement out = placed(sketch, scene, {.grid = {41, 5, 3}, .bending = bending});
        double most = 0;
        for (int i = 1; i + 1 < 41; ++i) {
            const auto z = [&](int k) { return out.contact.points[out.contact.index(k, 2)].z; };
            most = std::max(most, 2 * z(i) - z(i - 1) - z(i + 1));
        }
        return most;
    };
    EXPECT_LT(sharpest(10), 0.9 * sharpest(0));
}

TEST(Placement, InsideAnObjectIsRejectedWithWhatToDo)
{
    const RayScene scene = scene_of(sphere_mesh(20, 40, 20));
    EXPECT_THAT(
        [&] {
            placed(stroke(from_the_side(), {{300, 500}, {1200, 500}}), scene);
        },
        ThrowsMessage<Rejected>(HasSubstr("inside an object")));
    EXPECT_NO_THROW(
        placed(stroke(from_above(), {{300, 500}, {1200, 500}}), scene, {.height = 0.1}));
}

} // namespace
} // namespace trivar
