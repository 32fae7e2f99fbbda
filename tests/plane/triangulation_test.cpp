// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plane/triangulation.h"
#include "tests/plane/areas.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace trivar;

namespace {

std::int64_t area_inside(const Triangulation& plane)
{
    std::int64_t sum = 0;
    for (const auto& v : plane.inside()) {
        const auto at = [&](int i) { return plane.points()[static_cast<std::size_t>(i)]; };
        const std::int64_t area = turn(at(v[0]), at(v[1]), at(v[2]));
        EXPECT_GT(area, 0);
        sum += area;
    }
    return sum;
}

// A star of random radii: simple, as jagged as can be.
Loop star(int corners, std::uint32_t random, int scale)
{
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        random = random * 1664525u + 1013904223u;
        const double radius = scale * (0.1 + 0.9 * double(random >> 8) / (1 << 24));
        const double angle = 6.283185307179586 * i / corners;
        loop.emplace_back(glm::round(radius * glm::dvec2(std::cos(angle), std::sin(angle))));
    }
    return loop;
}

void add_loop(Triangulation& plane, const Loop& loop, std::vector<std::pair<int, int>>& edges)
{
    std::vector<int> points;
    for (const glm::ivec2& p : loop) points.push_back(plane.insert(p));
    for (std::size_t i = 0; i < points.size(); ++i)
        edges.emplace_back(points[i], points[(i + 1) % points.size()]);
}

} // namespace

TEST(Triangulation, FillsExactlyWhatItsEdgesEnclose)
{
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const Loop loop = star(5 + static_cast<int>(seed), seed, seed % 2 ? 1000000 : 60);
        Triangulation plane;
        std::vector<std::pair<int, int>> edges;
        add_loop(plane, loop, edges);
        bool simple = true;
        for (const auto& [a, b] : edges)
            simple &= plane.join(a, b) == Triangulation::JoinResult::one_edge;
        if (!simple) continue; // rounded onto itself
        plane.fill(edges);
        EXPECT_EQ(area_inside(plane), trivar::testing::doubled_area({loop})) << seed;
    }
}

TEST(Triangulation, KeepsItsAreaAndItsBoundsWhileItIsRefined)
{
    const Loop loop = with_short_edges({star(17, 7, 500000)}, 28000).front();
    Triangulation plane;
    std::vector<std::pair<int, int>> edges;
    add_loop(plane, loop, edges);
    for (const auto& [a, b] : edges) plane.join(a, b);
    plane.fill(edges);
    plane.refine(
        40000, [](const auto&) { return true; }, [](int, const auto&) {});
    EXPECT_EQ(area_inside(plane), trivar::testing::doubled_area({loop}));
    for (const auto& v : plane.inside())
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = [&](int p) {
                return glm::dvec2(plane.points()[static_cast<std::size_t>(p)]);
            };
            EXPECT_LE(glm::distance(at(v[i]), at(v[(i + 1) % 3])), 40000);
        }
}

TEST(Triangulation, JoinsAnyPointsWhereverTheyLie)
{
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        std::uint32_t random = seed;
        const auto below = [&](int most) {
            random = random * 1664525u + 1013904223u;
            return static_cast<int>((random >> 8) % static_cast<std::uint32_t>(most));
        };
        const int wide = seed % 2 ? most_units : 1000;
        Triangulation plane;
        std::vector<int> points;
        for (int i = 0; i < 12; ++i)
            points.push_back(plane.insert({below(2 * wide) - wide, below(2 * wide) - wide}));
        for (int i = 0; i < 40; ++i) {
            const int a = points[static_cast<std::size_t>(below(12))],
                      b = points[static_cast<std::size_t>(below(12))];
            if (a == b || plane.join(a, b) == Triangulation::JoinResult::crosses) continue;
            EXPECT_NE(plane.join(b, a), Triangulation::JoinResult::crosses) << seed; // it stays
        }
    }
}

TEST(Triangulation, TakesPointsOnEdgesAndInRows)
{
    Triangulation plane;
    std::vector<std::pair<int, int>> edges;
    Loop rows;
    for (int i = 0; i < 40; ++i) rows.emplace_back(i * 10, 0);
    for (int i = 40; i-- > 0;) rows.emplace_back(i * 10, 10);
    add_loop(plane, rows, edges);
    EXPECT_EQ(plane.insert({10, 0}), edges[1].first);
    for (const auto& [a, b] : edges)
        EXPECT_EQ(plane.join(a, b), Triangulation::JoinResult::one_edge);
    plane.fill(edges);
    EXPECT_EQ(area_inside(plane), 2 * 390 * 10);
    EXPECT_EQ(plane.join(edges[0].first, edges[20].first), Triangulation::JoinResult::several);
    EXPECT_EQ(plane.join(edges[0].first, edges[60].first), Triangulation::JoinResult::one_edge);
    EXPECT_EQ(plane.join(edges[5].first, edges[75].first), Triangulation::JoinResult::crosses);
}

TEST(Triangulation, TakesPointsOnEdgesThatStay)
{
    Triangulation plane;
    std::vector<std::pair<int, int>> edges;
    add_loop(plane, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}, edges);
    for (const auto& [a, b] : edges) plane.join(a, b);
    const int middle = plane.insert({50, 0});
    const auto [a, b] = edges.front();
    EXPECT_EQ(plane.join(a, b), Triangulation::JoinResult::several);
    edges.front() = {a, middle};
    edges.emplace_back(middle, b);
    for (const auto& [from, to] : edges)
        EXPECT_EQ(plane.join(from, to), Triangulation::JoinResult::one_edge);
    plane.fill(edges);
    EXPECT_EQ(area_inside(plane), 2 * 100 * 100);
}
