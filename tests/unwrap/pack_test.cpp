// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/pack.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

using Outline = std::vector<glm::dvec2>;

Outline box(double x, double y)
{
    return {{0, 0}, {x, 0}, {x, y}, {0, y}};
}

// The box of an outline where it is packed.
std::pair<glm::dvec2, glm::dvec2> packed_box(const Outline& outline, const PackedPlace& place)
{
    glm::dvec2 low(1e9), high(-1e9);
    for (const glm::dvec2& p : outline) {
        low = glm::min(low, place.turn * p + place.shift);
        high = glm::max(high, place.turn * p + place.shift);
    }
    return {low, high};
}

TEST(PackedOutlines, AreInTheirSquareAndApart)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> size(0.05, 1);
    std::vector<Outline> outlines;
    double area = 0;
    for (int k = 0; k < 100; ++k) {
        outlines.push_back(box(size(random), size(random) / 2));
        area += outlines.back()[2].x * outlines.back()[2].y;
    }
    const Packing out = packed(outlines, 1e-3);
    EXPECT_EQ(out.margin, 1e-3);
    EXPECT_GT(area / (out.side * out.side), 0.75);
    const double free = out.margin * out.side * (1 - 1e-9);
    for (std::size_t a = 0; a < outlines.size(); ++a) {
        const auto [low, high] = packed_box(outlines[a], out.places[a]);
        EXPECT_TRUE(low.x >= free && low.y >= free && high.x <= out.side - free &&
                    high.y <= out.side - free);
        for (std::size_t b = 0; b < a; ++b) {
            const auto [its_low, its_high] = packed_box(outlines[b], out.places[b]);
            const glm::dvec2 gap = glm::max(low - its_high, its_low - high);
            ASSERT_GE(std::max(gap.x, gap.y), 2 * free);
        }
    }
}

TEST(PackedOutlines, FillASquareThatFits)
{
    EXPECT_LT(packed(std::vector<Outline>(4, box(1, 1)), 0).side, 2.05);
}

TEST(PackedOutlines, LieInTheHollowsOfOthers)
{
    // Two angles of three squares each: boxes of two by two that share a square of four by one
    const Outline angle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    EXPECT_LT(packed(std::vector<Outline>(2, angle), 0).side, 3.1);
}

TEST(PackedOutlines, GetLessMarginWhereItWouldNeedTheWholeSquare)
{
    const Packing out = packed(std::vector<Outline>(400, box(1, 1)), 0.25);
    EXPECT_LT(out.margin, 0.02);
    EXPECT_LT(out.side, 60);
}

TEST(SmallestBox, IsThatOfATurnedRectangle)
{
    std::vector<glm::dvec2> points;
    for (const glm::dvec2 p : {glm::dvec2(0, 0), {1, 0}, {1, 3}, {0, 3}, {0.4, 1}})
        points.emplace_back(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y);
    const glm::dmat2 turn = smallest_box_turn(points);
    glm::dvec2 low(9), high(-9);
    for (const glm::dvec2& p : points) {
        low = glm::min(low, turn * p);
        high = glm::max(high, turn * p);
    }
    EXPECT_NEAR(high.x - low.x, 3, 1e-12); // wider than high
    EXPECT_NEAR(high.y - low.y, 1, 1e-12);
    EXPECT_NEAR(glm::determinant(turn), 1, 1e-12);
}

} // namespace
} // namespace trivar::testing
