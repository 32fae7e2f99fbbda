// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_kernel.h"

#include "core/mesh/primitives.h"
#include "tests/patches/patches.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// A ball of diameter 0.9 in the unit cell.
Mesh ball_in_cell(int segments = 17)
{
    Mesh out = sphere_mesh(0.45, segments, 9);
    for (glm::vec3& p : out.positions) p += 0.5f;
    out.tangents.assign(out.vertex_count(), {1, 0, 0, -1});
    return out;
}

struct Bent {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;
};

Bent bent_by_kernel(const Mesh& unit, const PlacedTile& tile)
{
    const std::size_t count = unit.vertex_count();
    Bent out{std::vector<glm::vec3>(count), std::vector<glm::vec3>(count),
             std::vector<glm::vec4>(count)};
    bend_vertices(TileVertices(unit), powers_of(tile), glm::vec3(0),
                  {out.positions.data(), out.normals.data(), out.tangents.data()});
    return out;
}

TEST(TileKernel, AgreesWithTheDefinitionAlsoSmallAndFarAway)
{
    const Mesh unit = ball_in_cell();
    for (const auto& [near, size] : {std::pair(glm::dvec3(0), 0.3),
                                     {glm::dvec3(1e6, -2e6, 5e5), 1e-3},
                                     {glm::dvec3(3), 1e-8},
                                     {glm::dvec3(0), 1e12}})
        for (const PlacedTile& tile : random_tiles(20, near, size)) {
            const glm::dvec3 origin = powers_of(tile).origin;
            const Bent out = bent_by_kernel(unit, tile);
            for (std::size_t v = 0; v < unit.vertex_count(); ++v) {
                const BentPoint truth =
                    bent_point(tile, glm::dvec3(unit.positions[v]), glm::dvec3(unit.normals[v]));
                EXPECT_LT(glm::distance(glm::dvec3(out.positions[v]), truth.p - origin),
                          1e-6 * size + 1e-9 * (1e-6 * glm::length(near)));
                EXPECT_LT(glm::distance(glm::dvec3(out.normals[v]), truth.normal),
                          glm::length(near) > 1e5 ? 1e-3 : 2e-5);
                EXPECT_NEAR(glm::length(glm::vec3(out.tangents[v])), 1, 1e-5);
                EXPECT_EQ(out.tangents[v].w, -1);
            }
        }
}

TEST(TileKernel, WritesNothingBehindTheLastVertex)
{
    std::mt19937 random(1);
    const PlacedTile tile = random_tile(random, glm::dvec3(0), 1);
    for (int segments = 3; segments < 12; ++segments) {
        const Mesh unit = ball_in_cell(segments);
        std::vector<glm::vec3> positions(unit.vertex_count() + 16, glm::vec3(77));
        bend_vertices(TileVertices(unit), powers_of(tile), glm::vec3(0),
                      {positions.data(), nullptr, nullptr});
        for (std::size_t v = unit.vertex_count(); v < positions.size(); ++v)
            EXPECT_EQ(positions[v], glm::vec3(77));
    }
}

TEST(TileKernel, GivesEveryVertexByItself)
{
    const Mesh unit = ball_in_cell();
    Mesh last = unit;
    for (auto* each : {&last.positions, &last.normals}) each->erase(each->begin(), each->end() - 5);
    last.tangents.clear();
    const PlacedTile tile = random_tiles(1).front();
    const Bent all = bent_by_kernel(unit, tile);
    std::vector<glm::vec3> positions(5), normals(5);
    bend_vertices(TileVertices(last), powers_of(tile), glm::vec3(0),
                  {positions.data(), normals.data(), nullptr});
    for (std::size_t v = 0; v < 5; ++v) {
        EXPECT_EQ(positions[v], all.positions[unit.vertex_count() - 5 + v]);
        EXPECT_EQ(normals[v], all.normals[unit.vertex_count() - 5 + v]);
    }
}

// A cell over a triangle: the whole side y = 1 is one point. All of it is flat.
PlacedTile tile_over_a_triangle()
{
    const glm::dvec3 a(2, 1, 0), b(3, 1, 1), c(2.3, 2, 0.5);
    PlacedTile out;
    for (std::size_t k = 0; k < 16; ++k) {
        const double u = static_cast<double>(k % 4) / 3, v = static_cast<double>(k / 4) / 3;
        out.patch.p[k] = (1 - v) * ((1 - u) * a + u * b) + v * c;
        out.patch.n[k] = glm::normalize(glm::cross(b - a, c - a));
    }
    return out;
}

TEST(TileKernel, GivesNormalsTheirLimitWhereASideOfThePatchHasNoLength)
{
    const PlacedTile tile = tile_over_a_triangle();
    const glm::dvec3 up = tile.patch.n[0];
    Mesh box = box_mesh({1, 1, 0.2}, {3, 3, 1});
    box.tangents.assign(box.vertex_count(), {1, 0, 0, 1});
    for (glm::vec3& p : box.positions) p += glm::vec3(0.5f, 0.5f, 0.1f);
    const std::vector<glm::vec3> normals = bent_by_kernel(box, tile).normals;
    std::size_t pinches = 0;
    for (std::size_t v = 0; v < box.vertex_count(); ++v) {
        pinches += box.positions[v].y == 1;
        if (std::abs(box.normals[v].z) == 1) {
            EXPECT_GT(glm::dot(glm::dvec3(normals[v]), double(box.normals[v].z) * up), 0.9999);
        } else {
            EXPECT_LT(std::abs(glm::dot(glm::dvec3(normals[v]), up)), 1e-3);
        }
    }
    EXPECT_GT(pinches, 8u);
}

TEST(TileKernel, GivesFlatTilesNormalsThatPointUp)
{
    PlacedTile flat;
    flat.patch.p.fill(glm::dvec3(1, 2, 3));
    flat.patch.n.fill(glm::dvec3(0, 0, 1));
    for (const glm::vec3& n : bent_by_kernel(ball_in_cell(), flat).normals)
        EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

} // namespace
} // namespace trivar
