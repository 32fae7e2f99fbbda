// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tiles/surface_maps.h"

#include "core/mesh/primitives.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

double distance_to(int a, int b, int size)
{
    return std::hypot(a % size - b % size, a / size - b / size);
}

double nearest_distance(const std::vector<char>& inside, int at, int size)
{
    double least = 1e300;
    for (int k = 0; k < int(inside.size()); ++k)
        if (inside[std::size_t(k)]) least = std::min(least, distance_to(k, at, size));
    return least;
}

TEST(JumpFlooding, FindsTheNearestTexelOfOneAndOfBlocks)
{
    constexpr int size = 64;
    for (const int block : {1, 6, 20}) {
        std::vector<char> inside(size * size, 0);
        for (int y = 0; y < block; ++y)
            for (int x = 0; x < block; ++x) inside[std::size_t((17 + y) * size + 31 + x)] = 1;
        const std::vector<int> nearest = flooded(inside, size);
        for (int k = 0; k < size * size; ++k)
            ASSERT_EQ(distance_to(nearest[std::size_t(k)], k, size),
                      nearest_distance(inside, k, size));
    }
}

TEST(JumpFlooding, IsOffByLittleAndSeldomForScatteredTexels)
{
    constexpr int size = 64;
    std::mt19937 random(5);
    int wrong = 0, all = 0;
    double most = 0;
    for (int run = 0; run < 10; ++run) {
        std::vector<char> inside(size * size, 0);
        for (int k = 0; k < 40; ++k) inside[random() % inside.size()] = 1;
        const std::vector<int> nearest = flooded(inside, size);
        for (int k = 0; k < size * size; ++k, ++all) {
            const double off =
                distance_to(nearest[std::size_t(k)], k, size) - nearest_distance(inside, k, size);
            wrong += off > 1e-9;
            most = std::max(most, off);
        }
    }
    EXPECT_LT(wrong, all / 500);
    EXPECT_LT(most, 1);
}

TEST(JumpFlooding, FindsNothingWhereNothingIs)
{
    for (const int each : flooded(std::vector<char>(64, 0), 8)) EXPECT_EQ(each, -1);
}

// Half of the square holds a plane, at an angle.
Mesh half_a_texture()
{
    Mesh mesh = plane_mesh({2, 1}, {4, 4});
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.positions[v].z = 0.5f * mesh.positions[v].x;
        mesh.uvs[0][v].x *= 0.5f;
    }
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

TEST(SurfaceMaps, AreExactOnAPlaneAndWhereTheyAreContinued)
{
    const SurfaceMaps maps = extended(surface_maps(half_a_texture(), 32), Extension::first_order);
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i) {
            const glm::dvec3 p = maps.p[std::size_t(32 * j + i)];
            const double x = 4 * (i + 0.5) / 32 - 1;
            EXPECT_LT(glm::distance(p, glm::dvec3(x, (j + 0.5) / 32 - 0.5, 0.5 * x)), 1e-6);
        }
}

TEST(SurfaceMaps, StayAtTheBorderWhereTheNearestValueCounts)
{
    const SurfaceMaps maps = extended(surface_maps(half_a_texture(), 32), Extension::nearest);
    for (int i = 16; i < 32; ++i) EXPECT_EQ(maps.p[std::size_t(i)], maps.p[15]);
}

TEST(SurfaceMaps, HaveCellsOfWhichTheyFillAShare)
{
    const std::vector<double> shares = valid_shares(surface_maps(half_a_texture(), 64), 8);
    for (int k = 0; k < 64; ++k) EXPECT_EQ(shares[std::size_t(k)], k % 8 < 4);
}

TEST(SurfaceMaps, BendTilesWithAnErrorThatFallsWithTheSquareOfTheirSize)
{
    const Mesh torus = torus_mesh(1, 0.4, {400, 200});
    double before = 0;
    for (const int size : {64, 128, 256}) {
        const SurfaceMaps maps = extended(surface_maps(torus, size), Extension::first_order);
        double off = 0;
        for (int j = 2; j < 14; ++j)
            for (int i = 2; i < 14; ++i) {
                const TilePatch patch = cell_patch(maps, 16, i, j);
                for (const double x : {0.25, 0.5, 0.75}) {
                    const glm::dvec3 p = tile_point(patch, {x, x, 0}).p;
                    const double round = std::hypot(std::hypot(p.x, p.y) - 1, p.z);
                    off = std::max(off, std::abs(round - 0.4));
                }
            }
        if (before > 0) {
            EXPECT_LT(off, before / 2) << size;
        }
        before = off;
    }
    EXPECT_LT(before, 1e-3);
}

} // namespace
} // namespace trivar::testing
