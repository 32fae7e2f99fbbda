// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/incise/piercing.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

struct LooseTriangles {
    std::vector<glm::dvec3> positions;
    std::vector<glm::uvec3> triangles;
};

// A bent sheet whose vertices stray, and triangles of any size and length across it.
LooseTriangles strewn(std::uint32_t seed, int n, double stray, int others)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto anywhere = [&](double size) {
        return size * glm::dvec3(unit(random), unit(random), unit(random));
    };
    LooseTriangles out;
    const auto vertex = [&](const glm::dvec3& p) {
        out.positions.push_back(p);
        return static_cast<std::uint32_t>(out.positions.size() - 1);
    };
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            const double x = 3.0 * i / n, y = 1.0 * j / n;
            vertex(glm::dvec3(x, 0.3 * std::sin(x), y) + anywhere(stray / n));
        }
    for (std::uint32_t i = 0; i + 1 < row; ++i)
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            const std::uint32_t v = i * row + j;
            out.triangles.emplace_back(v, v + 1, v + row);
            out.triangles.emplace_back(v + row, v + 1, v + row + 1);
        }
    for (int k = 0; k < others; ++k) {
        const glm::dvec3 at = glm::dvec3(1.5, 0, 0.5) + anywhere(1.5);
        const double size = k % 10 == 0 ? 1 : 0.1;
        const std::uint32_t a = vertex(at), b = vertex(at + anywhere(size));
        out.triangles.emplace_back(a, b, k % 3 == 0 ? a - 1 : vertex(at + anywhere(size)));
    }
    return out;
}

std::vector<PiercingPair> of_all_pairs(const LooseTriangles& all, std::span<const char> asked)
{
    std::vector<PiercingPair> out;
    for (std::uint32_t a = 0; a < all.triangles.size(); ++a)
        for (std::uint32_t b = a + 1; b < all.triangles.size(); ++b)
            if ((asked.empty() || asked[a] || asked[b]) &&
                pierce(all.positions, all.triangles[a], all.triangles[b]))
                out.push_back({a, b});
    return out;
}

TEST(Piercings, AreFoundButNotWhereTrianglesTouchOrShareAnEdge)
{
    const std::vector<glm::dvec3> p{{0, 0, 0},      {2, 0, 0},     {0, 2, 0},
                                    {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 0.5, 0},
                                    {0.5, 0, 0},    {0, -1, 0.5},  {1, -1, 0.5}};
    const std::vector<glm::uvec3> all{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 1, 4}};
    const std::vector<PiercingPair> found = piercings(p, all);
    EXPECT_EQ(found, (std::vector<PiercingPair>{{0, 1}}));
}

TEST(Piercings, AreThoseOfAllPairs)
{
    std::size_t found = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const LooseTriangles all = strewn(seed, 12, seed % 2 == 0 ? 0.1 : 1.5, 100);
        const std::vector<PiercingPair> pairs = of_all_pairs(all, {});
        EXPECT_EQ(piercings(all.positions, all.triangles), pairs);
        found += pairs.size();
    }
    EXPECT_GT(found, 500u);
}

TEST(Piercings, AreThoseOfTheTrianglesAskedFor)
{
    const LooseTriangles all = strewn(1, 12, 1, 100);
    std::vector<char> asked(all.triangles.size(), 0);
    for (std::size_t t = 0; t < asked.size(); t += 7) asked[t] = 1;
    EXPECT_EQ(piercings(all.positions, all.triangles, asked), of_all_pairs(all, asked));
}

TEST(Piercings, AreFoundInFlatAndInNoTriangles)
{
    EXPECT_TRUE(piercings(std::vector<glm::dvec3>{}, {}).empty());
    LooseTriangles flat = strewn(2, 4, 0, 40);
    for (glm::dvec3& p : flat.positions) p.y = 1;
    EXPECT_TRUE(piercings(flat.positions, flat.triangles).empty());
    for (glm::dvec3& p : flat.positions) p = glm::dvec3(1);
    EXPECT_TRUE(piercings(flat.positions, flat.triangles).empty());
}

TEST(Piercings, AreTheSameForAnyNumberOfThreads)
{
    const LooseTriangles all = strewn(3, 40, 1.5, 400);
    const std::vector<PiercingPair> found = piercings(all.positions, all.triangles);
    const ThreadLimit one(1);
    EXPECT_EQ(piercings(all.positions, all.triangles), found);
}

} // namespace
} // namespace trivar::testing
