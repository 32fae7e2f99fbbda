// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/level_surface.h"
#include "core/mesh/closed_body.h"
#include "tests/silhouette/scenes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace trivar::testing {
namespace {

Mesh surface(const Sampled& scene, LevelSide side, const glm::dmat4& to_space = glm::dmat4(1))
{
    return level_surface(scene.level(), std::span<const float>(scene.samples), scene.from.size,
                         side, to_space);
}

double volume(const Mesh& mesh)
{
    double out = 0;
    for (const glm::uvec3& t : triangles(mesh))
        out +=
            glm::dot(glm::dvec3(mesh.positions[t.x]),
                     glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
            6;
    return out;
}

glm::dmat4 mirrored_and_oblique()
{
    glm::dmat4 out(1);
    out[0] = {-0.5, 0, 0.1, 0};
    out[1] = {0, 0.7, 0, 0};
    out[2] = {0.2, 0, 1.1, 0};
    out[3] = {3, 4, 5, 1};
    return out;
}

TEST(LevelSurface, IsAClosedBody)
{
    for (const auto& [function, side] :
         {std::pair{"sphere", LevelSide::below}, std::pair{"gauss", LevelSide::above},
          std::pair{"waves", LevelSide::above}, std::pair{"waves", LevelSide::below}}) {
        const Sampled scene(function, 24);
        EXPECT_TRUE(is_closed_body(surface(scene, side))) << function;
        EXPECT_TRUE(is_closed_body(surface(scene, side, mirrored_and_oblique()))) << function;
    }
}

TEST(LevelSurface, OfBothSidesFillsTheGrid)
{
    for (const char* function : {"sphere", "gauss", "waves"}) {
        const Sampled scene(function, 24);
        EXPECT_NEAR(volume(surface(scene, LevelSide::above)) +
                        volume(surface(scene, LevelSide::below)),
                    23.0 * 23 * 23, 0.01)
            << function;
    }
}

TEST(LevelSurface, HasNormalsThatPointOutOfTheBody)
{
    const Sampled scene("sphere", 24);
    for (const glm::dmat4& to_space : {glm::dmat4(1), mirrored_and_oblique()}) {
        const Mesh mesh = surface(scene, LevelSide::below, to_space);
        for (const glm::uvec3& t : triangles(mesh)) {
            const glm::vec3 normal = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                                mesh.positions[t.z] - mesh.positions[t.x]);
            if (glm::length(normal) < 1e-3f) continue;
            for (int k = 0; k < 3; ++k)
                ASSERT_GT(glm::dot(glm::normalize(normal), mesh.normals[t[k]]), 0.7f);
        }
    }
    const double radius = 0.7 / scene.from.spacing;
    EXPECT_NEAR(volume(surface(scene, LevelSide::below)),
                4.0 / 3 * std::numbers::pi * radius * radius * radius,
                0.02 * radius * radius * radius * 4);
}

TEST(LevelSurface, OfALevelBeyondAllSamplesIsNothingOrTheGrid)
{
    const Sampled scene("gauss", 12);
    const LevelMesh none = scene.level(99);
    const std::span<const float> samples(scene.samples);
    EXPECT_EQ(
        level_surface(none, samples, scene.from.size, LevelSide::above, glm::dmat4(1)).face_count(),
        0u);
    const Mesh grid =
        level_surface(none, samples, scene.from.size, LevelSide::below, glm::dmat4(1));
    EXPECT_TRUE(is_closed_body(grid));
    EXPECT_NEAR(volume(grid), 11.0 * 11 * 11, 1e-3);
}

} // namespace
} // namespace trivar::testing
