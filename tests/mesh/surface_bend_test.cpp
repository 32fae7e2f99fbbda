// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_bend.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// Without the seams of texture coordinates, at which each side would be alone.
Mesh without_seams(const Mesh& mesh)
{
    Mesh out;
    out.positions.resize(point_count(mesh));
    out.normals.resize(out.positions.size());
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        out.positions[mesh.point(v)] = mesh.positions[v];
        out.normals[mesh.point(v)] = mesh.normals[v];
    }
    for (const glm::uvec3& t : triangles(mesh))
        add_face(out, std::array{mesh.point(t.x), mesh.point(t.y), mesh.point(t.z)});
    return out;
}

std::vector<std::uint32_t> corners_of(const Mesh& mesh)
{
    std::vector<std::uint32_t> out;
    for (const glm::uvec3& t : triangles(mesh)) out.insert(out.end(), {t.x, t.y, t.z});
    return out;
}

std::vector<SurfaceBend> bends_of(const Mesh& mesh)
{
    return surface_bends(mesh.positions, mesh.normals, corners_of(mesh));
}

TEST(SurfaceBends, OfABallAreTheSameAlongAllDirections)
{
    const Mesh ball = without_seams(sphere_mesh(2, 96, 48));
    const std::vector<SurfaceBend> bends = bends_of(ball);
    for (std::size_t i = 0; i < bends.size(); ++i) {
        const PrincipalBend found = principal(bends[i], ball.normals[i]);
        EXPECT_NEAR(found.greatest, 0.5, 0.005);
        EXPECT_NEAR(found.least, 0.5, 0.005);
        EXPECT_NEAR(bends[i].gauss(), 0.25, 0.005);
        EXPECT_LE(glm::length(bends[i] * ball.normals[i]), 1e-4f);
    }
}

TEST(SurfaceBends, OfARingAreGreatestRoundItsTube)
{
    constexpr float ring = 3, tube = 1;
    const Mesh torus = without_seams(torus_mesh(ring, tube, {128, 64}));
    const std::vector<SurfaceBend> bends = bends_of(torus);
    for (std::size_t i = 0; i < bends.size(); ++i) {
        const glm::vec3& p = torus.positions[i];
        const float out = std::hypot(p.x, p.y);
        const PrincipalBend found = principal(bends[i], torus.normals[i]);
        EXPECT_NEAR(found.greatest, 1 / tube, 0.01);
        EXPECT_NEAR(found.least, (out - ring) / tube / out, 0.01);
        const glm::vec3 round(-p.y / out, p.x / out, 0);
        EXPECT_LE(std::abs(glm::dot(found.direction, round)), 0.02f);
        EXPECT_NEAR(glm::length(found.direction), 1, 1e-5);
    }
}

TEST(SurfaceBends, ConvergeWithTheSquareOfTheSides)
{
    const auto error = [](int n) {
        const Mesh torus = without_seams(torus_mesh(3, 1, {2 * n, n}));
        const std::vector<SurfaceBend> bends = bends_of(torus);
        double worst = 0;
        for (std::size_t i = 0; i < bends.size(); ++i)
            worst = std::max(worst, std::abs(1.0 - principal(bends[i], torus.normals[i]).greatest));
        return worst;
    };
    EXPECT_GE(error(16) / error(32), 3.5);
    EXPECT_GE(error(32) / error(64), 3.5);
}

TEST(SurfaceBends, AreTheSameForAnyNumberOfThreads)
{
    const Mesh torus = without_seams(torus_mesh(3, 1, {90, 70}));
    const std::vector<SurfaceBend> all = bends_of(torus);
    const ThreadLimit one(1);
    const std::vector<SurfaceBend> alone = bends_of(torus);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].b, alone[i].b);
}

TEST(SurfaceBends, StayInTheTangentPlane)
{
    const glm::vec3 normal = glm::normalize(glm::vec3(1, -2, 0.5f));
    const SurfaceBend bend = in_tangent_plane({{1, 2, 3, 0.5f, -1, 0.25f}}, normal);
    EXPECT_LE(glm::length(bend * normal), 1e-5f);
    const auto [u, v] = tangents_of(normal);
    const SurfaceBend made = bend_of(u, v, {2, 0, -1});
    const PrincipalBend found = principal(made, normal);
    EXPECT_NEAR(found.greatest, 2, 1e-5);
    EXPECT_NEAR(found.least, -1, 1e-5);
    EXPECT_NEAR(made.gauss(), -2, 1e-5);
    EXPECT_NEAR(made.mean(), 0.5, 1e-5);
}

} // namespace
} // namespace trivar::testing
