// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/line_budget.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

Stroke straight(float y, float length, std::uint64_t edge, float slope = 1)
{
    Stroke out;
    out.id = edge;
    for (float x = 0; x <= length; ++x) out.points.push_back({.at = {x, y}, .slope = slope});
    return out;
}

std::vector<std::uint64_t> edges(const std::vector<Stroke>& strokes)
{
    std::vector<std::uint64_t> out;
    for (const Stroke& stroke : strokes) out.push_back(stroke.id);
    return out;
}

using Edges = std::vector<std::uint64_t>;

TEST(LineBudgets, KeepTheLongestLinesInTheirOrder)
{
    const std::vector<Stroke> all{straight(0, 10, 1), straight(10, 50, 2), straight(20, 40, 3)};
    EXPECT_EQ(edges(within_budget(all, 1)), Edges({1, 2, 3}));
    EXPECT_EQ(edges(within_budget(all, 0.85f)), Edges({2, 3}));
    EXPECT_EQ(edges(within_budget(all, 0.5f)), Edges({2}));
    EXPECT_TRUE(within_budget(all, 0).empty());
}

TEST(LineBudgets, CountSteepAndLastingLinesMore)
{
    std::vector<Stroke> all{straight(0, 40, 1, 8), straight(10, 60, 2), straight(20, 40, 3)};
    EXPECT_EQ(edges(within_budget(all, 0.2f)), Edges({1}));
    all[0] = straight(0, 40, 1);
    EXPECT_EQ(edges(within_budget(all, 0.2f)), Edges({2}));
    const std::vector<float> weights{1, 0.2f, 0.5f};
    EXPECT_EQ(edges(within_budget(all, 0.2f, weights)), Edges({1}));
}

TEST(LineBudgets, DoNotChangeTheirMindForAHair)
{
    const std::vector<Stroke> all{straight(0, 50, 1), straight(10, 52, 2)};
    EXPECT_EQ(edges(within_budget(all, 0.4f)), Edges({2}));
    const Edges before{1};
    EXPECT_EQ(edges(within_budget(all, 0.4f, {}, before)), Edges({1}));
}

TEST(LineBudgets, AreOfSeenAndOfHiddenLinesEach)
{
    std::vector<Stroke> all{straight(0, 50, 1), straight(10, 5, 2)};
    all[1].hidden = true;
    EXPECT_EQ(edges(within_budget(all, 0.5f)), Edges({1, 2}));
}

TEST(Persistence, IsTheShareOfALineThatStaysInPlace)
{
    const std::vector<Stroke> all{straight(0, 40, 1), straight(100, 40, 2)};
    const std::vector<std::vector<Stroke>> nearby{{straight(2, 40, 7)},
                                                  {straight(-1, 19, 8), straight(104, 40, 9)}};
    const std::vector<float> found = persistence(all, nearby, 3);
    EXPECT_NEAR(found[0], 0.77, 0.05);
    EXPECT_EQ(found[1], 0);
    EXPECT_EQ(persistence(all, {})[0], 1);
}

} // namespace
} // namespace trivar::testing
