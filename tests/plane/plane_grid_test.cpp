// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plane/plane_grid.h"

#include "core/plane/triangulation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN();

bool is_on_grid(const glm::ivec2& p)
{
    return std::abs(p.x) <= most_units - 8 && std::abs(p.y) <= most_units - 8;
}

TEST(PlaneGrid, HoldsPointsOfAnySizeAnywhereInTheirOrder)
{
    std::mt19937_64 dice(5);
    std::uniform_real_distribution<double> share(0, 1), power(-300, 300);
    for (int round = 0; round < 2000; ++round) {
        const glm::dvec2 lo(std::pow(10, power(dice)), -std::pow(10, power(dice)));
        glm::dvec2 hi = lo + glm::dvec2(std::pow(10, power(dice)), std::pow(10, power(dice)));
        if (round % 3 == 0) // a few units in the last place apart
            for (int k = 0; k < 2; ++k)
                for (hi[k] = lo[k]; share(dice) < 0.6;) hi[k] = std::nextafter(hi[k], endless);
        const PlaneGrid grid(lo, hi);
        EXPECT_TRUE(is_on_grid(grid.at(lo))) << round;
        EXPECT_TRUE(is_on_grid(grid.at(hi))) << round;
        const glm::dvec2 between = glm::clamp(glm::mix(lo, hi, share(dice)), lo, hi);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(grid.at(lo), grid.at(between)))) << round;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(grid.at(between), grid.at(hi)))) << round;
    }
}

TEST(PlaneGrid, HoldsWhatIsNoNumberAndWhatHasNoEnd)
{
    for (const double bad : {no_number, endless, -endless}) {
        EXPECT_TRUE(is_on_grid(PlaneGrid({0, 0}, {1, 1}).at({bad, 0.5})));
        EXPECT_TRUE(is_on_grid(PlaneGrid({0, bad}, {1, bad}).at({0.5, bad})));
        EXPECT_TRUE(is_on_grid(PlaneGrid({bad, bad}, {bad, bad}).at({0.5, 1})));
    }
}

TEST(PlaneGrid, UsesAllOfTheGridAndComesBack)
{
    const PlaneGrid grid({-3, 10}, {1, 11});
    EXPECT_EQ(grid.at({-3, 10.5}), glm::ivec2(-(most_units - 8), 0));
    EXPECT_EQ(grid.at({1, 10.5}), glm::ivec2(most_units - 8, 0));
    const glm::dvec2 p(0.25, 10.125);
    EXPECT_LT(glm::distance(grid.point(grid.at(p)), p), 1 / grid.scale);
}

TEST(Triangulation, TakesPointsAnywhereOnTheirGrid)
{
    Triangulation plane;
    constexpr int far = std::numeric_limits<int>::max();
    const int a = plane.insert({-far, -far}), b = plane.insert({far, -far}),
              c = plane.insert({0, far});
    ASSERT_EQ(plane.join(a, b), Triangulation::JoinResult::one_edge);
    ASSERT_EQ(plane.join(b, c), Triangulation::JoinResult::one_edge);
    ASSERT_EQ(plane.join(c, a), Triangulation::JoinResult::one_edge);
    EXPECT_TRUE(plane.fill({{a, b}, {b, c}, {c, a}}));
    EXPECT_EQ(plane.inside().size(), 1u);
}

} // namespace
} // namespace trivar
