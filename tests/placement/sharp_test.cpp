// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sharp.h"

#include "core/mesh/primitives.h"
#include "tests/placement/scenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

// Two planes that meet in the line x = 0, turned about Z: z = slope |x|.
RayScene folded(double slope, double turn_deg)
{
    return scene_of(height_field(12, 2, [&](double x, double) { return slope * std::abs(x); }),
                    glm::rotate(glm::dmat4(1), glm::radians(turn_deg), {0, 0, 1}));
}

// How far the surface is from those planes, of 201 x 41 samples.
struct Off {
    double mean = 0, most = 0;
};
Off off_fold(const Placement& placed, double slope, double turn_deg)
{
    const double angle = glm::radians(turn_deg);
    const glm::dvec2 across(std::cos(angle), std::sin(angle));
    Off off;
    for (int i = 0; i <= 200; ++i)
        for (int j = 0; j <= 40; ++j) {
            const glm::dvec3 p = evaluate(placed.contact, {i / 200.0, j / 40.0}).value;
            const double z = slope * std::abs(glm::dot(glm::dvec2(p), across));
            off.mean += std::abs(p.z - z) / (201 * 41);
            off.most = std::max(off.most, std::abs(p.z - z));
        }
    return off;
}

const PlacementParameters followed{.width = 0.4, .height = 0.2, .springs = false};

Placement across_it(const RayScene& scene, bool sharp, PlacementParameters p = followed)
{
    p.sharp = sharp;
    return placed(stroke(from_above(), {{310, 520}, {1220, 480}}), scene, p);
}

TEST(Sharp, TakesOnACreaseThatRunsAcrossTheStroke)
{
    for (const double slope : {-0.75, 0.75})
        for (const double turn : {0.0, 7.0, -3.0}) {
            const RayScene scene = folded(slope, turn);
            EXPECT_GT(off_fold(across_it(scene, false), slope, turn).most, 1e-3);
            EXPECT_LT(off_fold(across_it(scene, true), slope, turn).most, 1e-9)
                << slope << " " << turn;
        }
}

TEST(Sharp, TakesOnACreaseThatRunsAlongTheStroke)
{
    const RayScene scene = folded(-0.75, 93);
    EXPECT_GT(off_fold(across_it(scene, false), -0.75, 93).most, 1e-3);
    EXPECT_LT(off_fold(across_it(scene, true), -0.75, 93).most, 1e-9);
}

TEST(Sharp, HoldsForEveryOrderAndBothOffsets)
{
    const RayScene scene = folded(-0.75, 4);
    for (const int order : {2, 3, 4, 5})
        for (const double offset : {0.0, 1.0}) {
            PlacementParameters p = followed;
            p.orders = {order, order, 2};
            p.offset = offset;
            const Placement out = across_it(scene, true, p);
            EXPECT_LT(off_fold(out, -0.75, 4).most, 1e-9) << order;
            EXPECT_GT(out.report.smallest_jacobian, 0);
            for (int i = 0; i <= 300; ++i)
                for (const double w : {0.1, 0.9}) {
                    const auto f = evaluate(out.volume, {i / 300.0, 0.3, w}, 1).first;
                    EXPECT_GT(glm::determinant(glm::dmat3(f[0], f[1], f[2])), 0) << i;
                }
        }
}

TEST(Sharp, LiesOverARidgeWithSpringsToo)
{
    const RayScene scene = folded(-0.75, 4);
    EXPECT_LT(off_fold(across_it(scene, true, {.width = 0.4, .height = 0.2}), -0.75, 4).most, 1e-6);
}

TEST(Sharp, ComesSixTimesCloserToAnObliqueCrease)
{
    for (const double slope : {-0.75, 0.75})
        for (const double turn : {30.0, 50.0}) {
            const RayScene scene = folded(slope, turn);
            const Off before = off_fold(across_it(scene, false), slope, turn);
            const Off after = off_fold(across_it(scene, true), slope, turn);
            EXPECT_LT(after.mean, before.mean / 6) << slope << ", " << turn;
            EXPECT_LT(after.most, before.most / 1.5) << slope << ", " << turn;
        }
}

TEST(Sharp, LiesOnTheFacesOfABoxUpToItsEdge)
{
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.6, {0, 1, 0});
    const RayScene box = scene_of(box_mesh({1, 3, 1}, {1, 1, 1}), turned);
    const Placement out = across_it(box, true, {.width = 0.4, .height = 0.1, .springs = false});
    const glm::dmat3 back = glm::transpose(glm::dmat3(turned));
    for (int i = 0; i <= 200; ++i)
        for (const double v : {0.0, 0.31, 1.0}) {
            const double u = 0.25 + i / 400.0;
            const glm::dvec3 p = glm::abs(back * evaluate(out.contact, {u, v}).value);
            EXPECT_NEAR(std::max(p.x, p.z), 0.5, 1e-9) << u;
        }
}

// Boxes that touch, but for the rounding of their corners.
TEST(Sharp, TakesOnEveryStepOfStairs)
{
    std::vector<RayScene::Entry> steps;
    const auto add = [&](Mesh mesh, const glm::dvec3& at) {
        steps.push_back({std::make_shared<const RayMesh>(make_ref(std::move(mesh))),
                         glm::translate(glm::dmat4(1), at), static_cast<int>(steps.size())});
    };
    add(plane_mesh({9, 9}, {1, 1}), {});
    for (int k = 0; k < 4; ++k)
        add(box_mesh({2.6, 0.34, 0.22 * (k + 1)}, {1, 1, 1}), {0, 0.34 * k + 0.17, 0.11 * (k + 1)});
    const RayScene scene(std::move(steps));
    Camera camera;
    camera.eye = {0, -4.2, 4.6};
    camera.target = {0, 0.6, 0.3};
    camera.perspective = false;
    camera.height_world = 3.6;
    camera.size_px = {1280, 720};
    const Placement out = placed(stroke_over(camera, {{0.62, -0.55, 0}, {0.62, 1.3, 0.88}}), scene,
                                 {.width = 0.5, .height = 0.03, .springs = false, .sharp = true});
    EXPECT_LE(out.report.penetration, 1e-3);
    for (int i = 0; i <= 400; ++i) {
        const glm::dvec3 p = evaluate(out.contact, {i / 400.0, 0.3}).value;
        const double tread = 0.22 * std::clamp(std::floor(p.y / 0.34 + 1), 0.0, 4.0);
        const double riser = 0.34 * std::round(p.y / 0.34);
        EXPECT_LT(std::min(std::abs(p.z - tread), std::abs(p.y - riser)), 1e-6) << p.y;
    }
}

TEST(Sharp, TakesNoNoticeOfBackFacesThatAreSkipped)
{
    const auto field = [](double x, double) { return -0.75 * std::abs(x); };
    const auto ridge = std::make_shared<const RayMesh>(make_ref(height_field(12, 60, field)));
    const auto lid = std::make_shared<const RayMesh>(make_ref(plane_mesh({20, 20}, {1, 1})));
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), glm::radians(30.0), {0, 0, 1}),
                     upside_down = glm::translate(glm::dmat4(1), {0, 0, 1}) *
                                   glm::scale(glm::dmat4(1), {1, -1, -1});
    PlacementParameters p = followed;
    p.skip_back_faces = true;
    const Placement open = across_it(RayScene({{ridge, turned, 1}}), true, p),
                    under =
                        across_it(RayScene({{ridge, turned, 1}, {lid, upside_down, 2}}), true, p);
    EXPECT_EQ(under.volume, open.volume);
}

TEST(Sharp, NeverPenetratesFurtherThanAllowed)
{
    for (NamedScene& named : scenes_to_cover())
        for (const bool springs : {false, true}) {
            const Camera camera = from_the_side();
            PlacementParameters p{.springs = springs, .sharp = true};
            const Placement out = placed(stroke_to_cover(camera), named.scene, p);
            EXPECT_LE(out.report.penetration, 1e-3) << named.name;
            EXPECT_LE(penetration(out.contact, camera, named.scene, 151),
                      1.1e-3 * out.report.height_world)
                << named.name;
        }
}

TEST(Sharp, LeavesASmoothSceneToTheBit)
{
    const RayScene waves = scene_of(height_field(
        20, 200, [](double x, double y) { return 0.05 * std::sin(4 * x) * std::cos(3 * y); }));
    for (const bool springs : {false, true}) {
        PlacementParameters p = followed;
        p.springs = springs;
        EXPECT_EQ(across_it(waves, true, p).volume, across_it(waves, false, p).volume);
    }
}

} // namespace
} // namespace trivar
