// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/camera.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace trivar {
namespace {

std::vector<Camera> cameras()
{
    Camera oblique, straight_down, flat, flat_down;
    straight_down.eye = {1, 2, 9};
    straight_down.target = {1, 2, 0};
    flat.perspective = false;
    flat.size_px = {300, 700};
    flat_down = straight_down;
    flat_down.perspective = false;
    flat_down.height_world = 0.5;
    Camera wide = oblique;
    wide.fov_y = 2.5;
    wide.up = {0.3, 0.2, 1};
    return {oblique, straight_down, flat, flat_down, wide};
}

const std::vector<glm::dvec2> shares{{0, 0}, {1, 0}, {0.5, 0.5}, {0.2, 0.9}, {1, 1}};

TEST(Camera, APointOnAPixelsRayIsSeenAtThatPixel)
{
    for (const Camera& camera : cameras())
        for (const glm::dvec2& share : shares) {
            const glm::dvec2 p_px = share * camera.size_px;
            const Ray ray = ray_through(camera, p_px);
            EXPECT_NEAR(glm::length(ray.direction), 1, 1e-14);
            for (const double distance : {0.5, 3.0, 100.0}) {
                const auto seen = project(camera, ray.origin + distance * ray.direction);
                EXPECT_LT(glm::distance(seen.p_px, p_px), 1e-9);
                EXPECT_GT(seen.depth_world, 0);
            }
        }
}

TEST(Camera, TheMiddlePixelLooksAtTheTarget)
{
    for (const Camera& camera : cameras()) {
        const PicturePoint seen = project(camera, camera.target);
        EXPECT_LT(glm::distance(seen.p_px, camera.size_px / 2.0), 1e-9);
        EXPECT_NEAR(seen.depth_world, glm::distance(camera.eye, camera.target), 1e-12);
    }
}

TEST(Camera, PixelsGoRightAndDown)
{
    Camera camera; // at -y, looking along +y, z up
    camera.eye = {0, -5, 0};
    const glm::dvec2 middle = camera.size_px / 2.0;
    EXPECT_GT(project(camera, {1, 0, 0}).p_px.x, middle.x);
    EXPECT_LT(project(camera, {0, 0, 1}).p_px.y, middle.y);
}

TEST(Camera, APointBehindHasANegativeDepth)
{
    for (const Camera& camera : cameras()) {
        const glm::dvec3 behind = camera.eye - (camera.target - camera.eye);
        EXPECT_LT(project(camera, behind).depth_world, 0);
    }
}

TEST(Camera, APixelIsAsLargeAsTheDistanceBetweenNeighbouringRays)
{
    for (const Camera& camera : cameras()) {
        const double depth = 3;
        const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
        const auto at_depth = [&](glm::dvec2 p_px) {
            const Ray ray = ray_through(camera, p_px);
            return ray.origin + ray.direction * (depth / glm::dot(ray.direction, forward));
        };
        const glm::dvec2 p = camera.size_px * glm::dvec2(0.3, 0.8);
        EXPECT_NEAR(glm::distance(at_depth(p), at_depth(p + glm::dvec2(0, 1))),
                    pixel_size_world(camera, depth), 1e-12);
    }
}

// The rays meet the points that the renderer draws.
TEST(Camera, MatricesAndProjectionAgree)
{
    for (const Camera& camera : cameras()) {
        const glm::dmat4 clip = projection_matrix(camera, 0.1, 50) * view_matrix(camera);
        for (const glm::dvec2& share : shares) {
            const Ray ray = ray_through(camera, share * camera.size_px);
            const glm::dvec3 p = ray.origin + 2.5 * ray.direction;
            const glm::dvec4 h = clip * glm::dvec4(p, 1);
            const glm::dvec2 px =
                (glm::dvec2(h) / h.w * glm::dvec2(0.5, -0.5) + 0.5) * camera.size_px;
            EXPECT_LT(glm::distance(px, share * camera.size_px), 1e-9);
            EXPECT_LT(std::abs(h.z / h.w), 1);
        }
    }
}

TEST(Camera, NearAndFarAreTheEndsOfTheDepthRange)
{
    for (const Camera& camera : cameras()) {
        const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
        const glm::dmat4 clip = projection_matrix(camera, 0.5, 20) * view_matrix(camera);
        const auto depth = [&](double distance) {
            const glm::dvec4 h = clip * glm::dvec4(camera.eye + distance * forward, 1);
            return h.z / h.w;
        };
        EXPECT_NEAR(depth(0.5), -1, 1e-12);
        EXPECT_NEAR(depth(20), 1, 1e-12);
    }
}

} // namespace
} // namespace trivar
