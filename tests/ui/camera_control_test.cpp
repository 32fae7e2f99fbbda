// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera_control.h"

#include "core/base/box.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace trivar::ui {
namespace {

constexpr double tolerance_px = 1e-6;

Camera somewhere()
{
    Camera camera;
    camera.eye = {3, -5, 2.5};
    camera.target = {0.4, 0.2, 0.3};
    return camera;
}

std::vector<Camera> both_kinds()
{
    return {somewhere(), with_perspective(somewhere(), false)};
}

void expect_same_pixel(const Camera& before, const Camera& after, const glm::dvec3& p,
                       glm::dvec2 moved_px = {0, 0})
{
    const glm::dvec2 a = project(before, p).p_px + moved_px, b = project(after, p).p_px;
    EXPECT_NEAR(a.x, b.x, tolerance_px);
    EXPECT_NEAR(a.y, b.y, tolerance_px);
}

TEST(CameraControl, OrbitKeepsThePivotWhereItIsInThePicture)
{
    const glm::dvec3 pivot(0.7, -0.5, 0.1);
    for (const Camera& camera : both_kinds())
        expect_same_pixel(camera, orbited(camera, pivot, {140, -60}), pivot);
}

TEST(CameraControl, OrbitKeepsTheDistanceAndTheHorizon)
{
    for (const Camera& camera : both_kinds()) {
        const Camera turned = orbited(camera, camera.target, {-333, 5000});
        EXPECT_NEAR(glm::distance(turned.eye, turned.target),
                    glm::distance(camera.eye, camera.target), 1e-9);
        // A vertical line stays upright in the middle of the picture: no roll.
        const glm::dvec2 low = project(turned, turned.target).p_px;
        const glm::dvec2 high = project(turned, turned.target + glm::dvec3(0, 0, 0.1)).p_px;
        EXPECT_NEAR(low.x, high.x, 1e-6);
        EXPECT_LT(high.y, low.y) << "up is up, even after a drag far beyond the pole";
    }
}

TEST(CameraControl, OrbitThereAndBackIsWhereItBegan)
{
    const Camera camera = somewhere();
    const Camera back = orbited(orbited(camera, {1, 1, 0}, {80, 0}), {1, 1, 0}, {-80, 0});
    EXPECT_NEAR(glm::distance(camera.eye, back.eye), 0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.target, back.target), 0, 1e-12);
}

TEST(CameraControl, PanFollowsThePointerExactly)
{
    const glm::dvec3 anchor(0.3, 0.9, -0.2);
    for (const Camera& camera : both_kinds())
        expect_same_pixel(camera, panned(camera, anchor, {37, -21}), anchor, {37, -21});
}

TEST(CameraControl, ZoomKeepsTheAnchorAndChangesItsSizeByTheFactor)
{
    const glm::dvec3 anchor(0.3, 0.9, -0.2);
    for (const Camera& camera : both_kinds()) {
        const Camera nearer = zoomed(camera, anchor, 0.8);
        expect_same_pixel(camera, nearer, anchor);
        const auto pixel = [&](const Camera& c) {
            return pixel_size_world(c, project(c, anchor).depth_world);
        };
        EXPECT_NEAR(pixel(nearer) / pixel(camera), 0.8, 1e-9);
    }
}

TEST(CameraControl, ZoomStopsBeforeTheCameraReachesItsTargetOrLeavesTheWorld)
{
    Camera in = somewhere(), out = somewhere();
    for (int i = 0; i < 400; ++i) {
        in = zoomed(in, in.target, 0.5);
        out = zoomed(out, out.target, 2);
    }
    EXPECT_GE(glm::distance(in.eye, in.target), 0.99e-8);
    EXPECT_LE(glm::distance(out.eye, out.target), 1.01e10);
}

TEST(CameraControl, FramedPointsFillFourFifthsOfThePictureOneWay)
{
    Box box;
    box.add({-2, 1, 0});
    box.add({3, 2, 4});
    std::vector<glm::dvec3> points;
    for (int corner = 0; corner < 8; ++corner)
        points.emplace_back((corner & 1 ? box.hi : box.lo).x, (corner & 2 ? box.hi : box.lo).y,
                            (corner & 4 ? box.hi : box.lo).z);
    for (const glm::dvec2 size : {glm::dvec2(1600, 400), glm::dvec2(300, 900)})
        for (Camera camera : both_kinds()) {
            camera.size_px = size;
            const Camera result = framed(camera, points);
            Box seen;
            for (const glm::dvec3& p : points) seen.add(glm::dvec3(project(result, p).p_px, 0));
            const glm::dvec2 share = glm::dvec2(seen.size()) / size;
            EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-9);
            const double off_x = seen.center().x - size.x / 2, off_y = seen.center().y - size.y / 2;
            EXPECT_NEAR(share.x > share.y ? off_x : off_y, 0, 1e-6);
            EXPECT_TRUE(seen.lo.x >= 0 && seen.lo.y >= 0 && seen.hi.x <= size.x &&
                        seen.hi.y <= size.y);
        }
}

TEST(CameraControl, FramesCellsAndCountriesAlike)
{
    for (const double scale : {1e-6, 1e-5, 1e5, 1e6, 1e7})
        for (const Camera& camera : both_kinds()) {
            const std::vector<glm::dvec3> points{{-scale, 0, 0}, {scale, scale, 0}, {0, 0, scale}};
            const Camera result = framed(camera, points);
            Box seen;
            for (const glm::dvec3& p : points) seen.add(glm::dvec3(project(result, p).p_px, 0));
            const glm::dvec2 share = glm::dvec2(seen.size()) / camera.size_px;
            EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-6) << scale;
        }
}

TEST(CameraControl, FramedPointsStayAboveTheFootThatIsCovered)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-2, 2);
    for (int round = 0; round < 40; ++round)
        for (Camera camera : both_kinds()) {
            std::vector<glm::dvec3> points;
            for (int i = 0; i < 12; ++i)
                points.emplace_back(uniform(random), uniform(random), uniform(random));
            camera.size_px = {700 + 100 * (round % 7), 600};
            const double foot = 15.0 * (round % 20);
            const Camera result = framed(camera, points, foot);
            Box seen;
            for (const glm::dvec3& p : points) seen.add(glm::dvec3(project(result, p).p_px, 0));
            EXPECT_LE(seen.hi.y, 600 - foot - 0.1 * (600 - foot) + 1e-6);
            EXPECT_GE(seen.lo.y, 0.1 * (600 - foot) - 1e-6);
            EXPECT_GE(seen.lo.x, 0);
            EXPECT_LE(seen.hi.x, camera.size_px.x);
            const glm::dvec2 share =
                glm::dvec2(seen.size()) / glm::dvec2(camera.size_px.x, 600 - foot);
            EXPECT_NEAR(std::max(share.x, share.y), 0.8, 1e-9) << "no smaller than it has to be";
        }
}

TEST(CameraControl, OnePointIsFramedFromNearby)
{
    for (const Camera& camera : both_kinds()) {
        const std::vector<glm::dvec3> point{{1, 2, 3}};
        const Camera result = framed(camera, point);
        EXPECT_NEAR(glm::distance(project(result, point[0]).p_px, camera.size_px / 2.0), 0, 1e-3);
        EXPECT_GT(glm::distance(result.eye, point[0]), 0);
    }
}

TEST(CameraControl, FramingNothingChangesNothing)
{
    EXPECT_EQ(framed(somewhere(), {}), somewhere());
}

TEST(CameraControl, AnotherShapeOfPictureShowsAllThatWasInTheViewBefore)
{
    for (const Camera& camera : both_kinds())
        for (const glm::dvec2 size : {glm::dvec2(1280, 720), {2560, 720}, {700, 780}, {300, 900}}) {
            const Camera now = reshaped(camera, size);
            EXPECT_EQ(now.size_px, size);
            EXPECT_EQ(now.eye, camera.eye);
            for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1280, 0}, {0, 720}, {1280, 720}}) {
                const glm::dvec2 p = project(now, point_at_target_depth(camera, corner)).p_px;
                EXPECT_GE(std::min(p.x, p.y), -tolerance_px);
                EXPECT_LE(p.x, size.x + tolerance_px);
                EXPECT_LE(p.y, size.y + tolerance_px);
            }
        }
    EXPECT_EQ(reshaped(somewhere(), {640, 360}).fov_y, somewhere().fov_y);
}

TEST(CameraControl, FromAboveAndBelowXGoesToTheRightHoweverTheViewWasTurned)
{
    for (const double up : {1.0, -1.0}) {
        for (const glm::dvec3& before : {glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0),
                                         glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0)}) {
            const Camera turned = orbited(seen_from(somewhere(), before), {}, {20, 0});
            const Camera camera = seen_from(turned, {0, 0, up});
            const glm::dvec2 origin = project(camera, camera.target).p_px;
            const glm::dvec2 east = project(camera, camera.target + glm::dvec3(1, 0, 0)).p_px;
            const glm::dvec2 north = project(camera, camera.target + glm::dvec3(0, 1, 0)).p_px;
            EXPECT_GT(east.x, origin.x);
            EXPECT_NEAR(east.y, origin.y, tolerance_px);
            EXPECT_NEAR(north.x, origin.x, tolerance_px);
            EXPECT_EQ(north.y<origin.y, up> 0);
        }
    }
}

TEST(CameraControl, ChangingTheProjectionKeepsSizesAtTheTarget)
{
    const Camera camera = somewhere();
    const Camera flat = with_perspective(camera, false);
    const glm::dvec3 side =
        glm::normalize(glm::cross(camera.target - camera.eye, glm::dvec3(0, 0, 1)));
    expect_same_pixel(camera, flat, camera.target + side);
    expect_same_pixel(camera, with_perspective(flat, true), camera.target + side);
}

TEST(CameraControl, ThePointAtTheTargetsDepthLiesUnderItsPixel)
{
    for (const Camera& camera : both_kinds()) {
        const PicturePoint p = project(camera, point_at_target_depth(camera, {100, 650}));
        EXPECT_NEAR(p.p_px.x, 100, tolerance_px);
        EXPECT_NEAR(p.p_px.y, 650, tolerance_px);
        EXPECT_NEAR(p.depth_world, project(camera, camera.target).depth_world, 1e-9);
    }
}

} // namespace
} // namespace trivar::ui
