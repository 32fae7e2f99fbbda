// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

glm::dvec3 any(std::mt19937& random)
{
    std::uniform_real_distribution<double> place(-1, 1);
    return {place(random), place(random), place(random)};
}

} // namespace

TEST(Reach, MeasuresTheDistanceFromATriangle)
{
    std::mt19937 random(3);
    for (int n = 0; n < 200; ++n) {
        Triangle3 t{any(random), any(random), any(random)};
        if (n % 4 == 1) t[2] = t[0] + 0.3 * (t[1] - t[0]); // a line
        if (n % 4 == 2) t[2] = t[1] = t[0];                // a point
        const glm::dvec3 p = 2.0 * any(random);
        double least = 1e300;
        constexpr int steps = 60;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j)
                least =
                    std::min(least, glm::distance(p, t[0] + (t[1] - t[0]) * (i / double(steps)) +
                                                         (t[2] - t[0]) * (j / double(steps))));
        const double distance = std::sqrt(distance_squared(p, t));
        EXPECT_LE(distance, least + 1e-12);
        EXPECT_GE(distance, least - 0.05);
    }
}

TEST(Reach, CoversWhatLiesAcrossAnEdge)
{
    const Reach two({{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, {{{2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}});
    const Triangle3 across{{{0.5, 0.5, 0.01}, {1.5, 1.2, 0.01}, {1.2, 1.6, -0.01}}};
    EXPECT_TRUE(two.covers(across, 0.0101));
    EXPECT_FALSE(two.covers(across, 0.0099));
}

TEST(Reach, CoversAPlaneWithAnotherCutOfIt)
{
    const Mesh fine = plane_mesh({2, 2}, {30, 30});
    const Reach many(placed_triangles(fine));
    for (const Triangle3& t : placed_triangles(plane_mesh({2, 2}, {1, 1})))
        EXPECT_TRUE(many.covers(t, 1e-9));
    const Reach hole([&] {
        std::vector<Triangle3> some = placed_triangles(fine);
        some.erase(some.begin() + 777);
        return some;
    }());
    int proven = 0;
    for (const Triangle3& t : placed_triangles(plane_mesh({2, 2}, {1, 1}))) {
        proven += hole.covers(t, 1e-3);
        EXPECT_TRUE(hole.covers(t, 0.1)); // the hole is smaller
    }
    EXPECT_EQ(proven, 1);
}

TEST(Reach, CoversWhatLiesAtACornerThatManyShare)
{
    std::vector<Triangle3> fan;
    const auto rim = [](int i) {
        return glm::dvec3(std::cos(0.1 * i), std::sin(0.1 * i), 0.3 * std::cos(0.1 * i));
    };
    for (int i = 0; i < 63; ++i) fan.push_back({glm::dvec3(0), rim(i), rim(i + 1)});
    const Reach reach(fan);
    EXPECT_TRUE(reach.covers({0.5 * rim(3), 0.6 * rim(21), 0.4 * rim(44)}, 1e-9));
    EXPECT_FALSE(reach.covers({0.5 * rim(3), 1.1 * rim(21), 0.4 * rim(44)}, 1e-9));
}

TEST(Reach, NeverProvesWhatASampleDenies)
{
    std::mt19937 random(5);
    int proven = 0;
    for (int n = 0; n < 300; ++n) {
        std::vector<Triangle3> some;
        for (int i = 0; i < 6; ++i) some.push_back({any(random), any(random), any(random)});
        const Triangle3 asked{0.7 * any(random), 0.7 * any(random), 0.7 * any(random)};
        const double distance = 0.05 + 0.9 * std::abs(any(random).x);
        if (!Reach(some).covers(asked, distance)) continue;
        ++proven;
        for (int k = 0; k < 200; ++k) {
            double a = std::abs(any(random).x), b = std::abs(any(random).x);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            double least = 1e300;
            for (const Triangle3& t : some)
                least = std::min(least, distance_squared(asked[0] + a * (asked[1] - asked[0]) +
                                                             b * (asked[2] - asked[0]),
                                                         t));
            EXPECT_LE(std::sqrt(least), distance);
        }
    }
    EXPECT_GT(proven, 50);
}

TEST(Reach, OfNothingCoversNothing)
{
    EXPECT_FALSE(Reach().covers({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 1e9));
}

} // namespace trivar::testing
