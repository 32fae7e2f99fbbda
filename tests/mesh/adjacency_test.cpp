// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/primitives.h"
#include "tests/mesh/edges.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

// Triangles and quads between any points, also one point twice, and split vertices.
Mesh soup(unsigned seed)
{
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    Mesh mesh;
    mesh.positions.resize(60);
    for (std::size_t v = 0; v < 60; ++v) mesh.points.push_back(below(40));
    for (int f = 0; f < 100; ++f) {
        std::vector<std::uint32_t> face(3 + below(2));
        for (std::uint32_t& v : face) v = below(60);
        add_face(mesh, face);
    }
    return mesh;
}

Mesh three_wings() // round the edge from 0 to 1
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    add_face(mesh, std::array{0u, 1u, 2u});
    add_face(mesh, std::array{1u, 0u, 3u});
    add_face(mesh, std::array{1u, 0u, 4u});
    return mesh;
}

} // namespace

TEST(Adjacency, HasEverySideAtTheEdgeBetweenItsEnds)
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Mesh mesh = soup(seed);
        const Adjacency adjacency(mesh);
        std::vector<int> met(mesh.corners.size(), 0);
        for (std::uint32_t e = 0; e < adjacency.edge_count(); ++e) {
            const glm::uvec2 ends = adjacency.edges()[e];
            EXPECT_LE(ends.x, ends.y);
            EXPECT_TRUE(std::ranges::is_sorted(adjacency.sides(e)));
            for (const std::uint32_t side : adjacency.sides(e)) {
                const std::uint32_t from = mesh.point(mesh.corners[side]);
                const std::uint32_t to = mesh.point(mesh.corners[adjacency.next(side)]);
                EXPECT_EQ(glm::uvec2(std::min(from, to), std::max(from, to)), ends);
                EXPECT_EQ(adjacency.edge_at(side), e);
                EXPECT_EQ(adjacency.upward(side), from <= to);
                ++met[side];
            }
        }
        EXPECT_TRUE(std::ranges::all_of(met, [](int n) { return n == 1; }));
    }
}

TEST(Adjacency, HasEachEdgeOnceInAscendingOrder)
{
    const Adjacency adjacency(soup(1));
    const auto edges = adjacency.edges();
    ASSERT_GT(edges.size(), 100u);
    for (std::size_t e = 1; e < edges.size(); ++e)
        EXPECT_LT(std::pair(edges[e - 1].x, edges[e - 1].y), std::pair(edges[e].x, edges[e].y));
}

TEST(Adjacency, HasTheCornersRoundEachPoint)
{
    const Mesh mesh = soup(2);
    const Adjacency adjacency(mesh);
    ASSERT_EQ(adjacency.point_count(), point_count(mesh));
    for (std::uint32_t p = 0; p < adjacency.point_count(); ++p) {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = 0; c < mesh.corners.size(); ++c)
            if (mesh.point(mesh.corners[c]) == p) corners.push_back(c);
        EXPECT_TRUE(std::ranges::equal(adjacency.corners(p), corners));
    }
}

TEST(Adjacency, FindsTheEdgeBetweenTwoPointsFromEitherEnd)
{
    const Adjacency adjacency(three_wings());
    for (std::uint32_t e = 0; e < adjacency.edge_count(); ++e) {
        const glm::uvec2 ends = adjacency.edges()[e];
        EXPECT_EQ(adjacency.edge_between(ends.x, ends.y), e);
        EXPECT_EQ(adjacency.edge_between(ends.y, ends.x), e);
    }
    EXPECT_EQ(adjacency.edge_between(2, 3), std::nullopt);
}

TEST(Adjacency, KnowsTheFaceOfACorner)
{
    const Mesh mesh = soup(3);
    const Adjacency adjacency(mesh);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            EXPECT_EQ(adjacency.face(c), f);
            EXPECT_EQ(adjacency.previous(adjacency.next(c)), c);
            EXPECT_EQ(adjacency.face(adjacency.next(c)), f);
        }
}

TEST(Adjacency, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = torus_mesh(2, 0.7, {300, 200});
    const Adjacency several(mesh);
    const ThreadLimit one(1);
    const Adjacency alone(mesh);
    EXPECT_TRUE(std::ranges::equal(several.edges(), alone.edges()));
    for (std::uint32_t e = 0; e < alone.edge_count(); ++e)
        ASSERT_TRUE(std::ranges::equal(several.sides(e), alone.sides(e)));
    for (std::uint32_t c = 0; c < mesh.corners.size(); ++c)
        ASSERT_EQ(several.edge_at(c), alone.edge_at(c));
}

TEST(Adjacency, ClosesSeamsBetweenPointsAndNotBetweenVertices)
{
    const Mesh box = box_mesh({1, 1, 1}, {1, 1, 1}); // six quads with four vertices each
    EXPECT_EQ(Adjacency(box).edge_count(), 12u);
    EXPECT_TRUE(Adjacency(box).is_closed());
    const Adjacency split(box, Adjacency::Ends::vertices);
    EXPECT_EQ(split.edge_count(), 24u);
    EXPECT_FALSE(split.is_closed());
    EXPECT_TRUE(split.has_border());
}

TEST(Adjacency, CountsAsTheTestsOwnTableDoes)
{
    for (const Mesh& mesh : {torus_mesh(2, 0.7, {12, 8}), moebius_mesh(1, 0.4, {24, 3}),
                             plane_mesh({1, 1}, {3, 4}), three_wings(), Mesh{}}) {
        const EdgeCount counted = count_edges(mesh);
        const Adjacency adjacency(mesh);
        int open = 0, against = 0, crowded = 0;
        for (std::uint32_t e = 0; e < adjacency.edge_count(); ++e) {
            const std::size_t sides = adjacency.sides(e).size();
            open += adjacency.is_border(e);
            crowded += sides > 2;
            against += sides == 2 && !adjacency.is_manifold(e);
        }
        EXPECT_EQ(static_cast<int>(adjacency.edge_count()), counted.edges);
        EXPECT_EQ(open, counted.open);
        EXPECT_EQ(against, counted.against);
        EXPECT_EQ(crowded, counted.crowded);
        EXPECT_EQ(adjacency.has_border(), counted.open > 0);
    }
}

TEST(Adjacency, AnEdgeOfThreeFacesIsNotManifold)
{
    const Adjacency adjacency(three_wings());
    EXPECT_EQ(adjacency.sides(0).size(), 3u);
    EXPECT_FALSE(adjacency.is_manifold(0));
    EXPECT_FALSE(adjacency.is_border(0));
    EXPECT_FALSE(adjacency.is_closed());
}

} // namespace trivar::testing
