// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/ink.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// Two lines, the second one hidden, whose slopes and depths grow from 0 to 99.
std::vector<Stroke> two_lines()
{
    std::vector<Stroke> out(2);
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i);
        out[0].points.push_back({.at = {x, 10}, .depth = x, .slope = x});
        out[1].points.push_back({.at = {x, 20}, .depth = x, .slope = x});
    }
    out[0].id = 0xabc;
    out[1].hidden = true;
    return out;
}

TEST(Ink, TapersLooseEnds)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.width = 2, .taper = 10});
    ASSERT_EQ(lines.size(), 1u); // hidden ones are left out
    EXPECT_FLOAT_EQ(lines[0].points[50].width, 2);
    EXPECT_LT(lines[0].points.front().width, 1);
    EXPECT_LT(lines[0].points.back().width, 1);
    EXPECT_FALSE(lines[0].is_even());
    EXPECT_TRUE(inked(two_lines(), {.taper = 0})[0].is_even());
}

TEST(Ink, FollowsTheSlopeOfTheField)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.width = 2,
                                                             .finest = 0.25f,
                                                             .width_by = LineWidth::by_slope,
                                                             .color_by = LineColor::hue_by_depth,
                                                             .taper = 0});
    EXPECT_FLOAT_EQ(lines[0].points.front().width, 2);
    EXPECT_FLOAT_EQ(lines[0].points.back().width, 0.5f);
    EXPECT_EQ(lines[0].points.front().color, glm::vec3(1, 0, 0));
    EXPECT_EQ(lines[0].points.back().color, glm::vec3(0, 0, 1));
}

TEST(Ink, DrawsHiddenLinesFirstAndAsTold)
{
    const auto hidden = [](HiddenLines how) { return inked(two_lines(), {.hidden = how}).at(0); };
    EXPECT_TRUE(hidden(HiddenLines::dashed).dashed);
    EXPECT_LT(hidden(HiddenLines::faint).opacity, 1);
    EXPECT_EQ(hidden(HiddenLines::as_seen).opacity, 1);
    EXPECT_TRUE(hidden(HiddenLines::as_seen).hidden);
}

TEST(Ink, WobblesTheSameForTheSameSeed)
{
    const LineStyle style{.wobble = 3, .seed = 7};
    const auto at = [](const std::vector<InkedLine>& lines, std::size_t i) {
        return lines[0].points[i].at;
    };
    const std::vector<InkedLine> once = inked(two_lines(), style),
                                 again = inked(two_lines(), style),
                                 other = inked(two_lines(), {.wobble = 3, .seed = 8});
    double differ = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(at(once, i), at(again, i));
        EXPECT_LE(std::abs(at(once, i).y - 10), 3);
        differ += glm::distance(at(once, i), at(other, i));
    }
    EXPECT_GT(differ, 10);
}

TEST(Ink, KeepsAWobbleWhereItIsInSpace)
{
    std::vector<Stroke> moved = two_lines(), whole = two_lines();
    for (std::vector<Stroke>* strokes : {&moved, &whole})
        for (Stroke& stroke : *strokes)
            for (StrokePoint& p : stroke.points) p.p = {p.at / 4.0f, 7};
    moved[0].points.erase(moved[0].points.begin(), moved[0].points.begin() + 20);
    const LineStyle style{.taper = 0, .wobble = 3};
    const std::vector<InkedLine> a = inked(whole, style), b = inked(moved, style);
    for (std::size_t i = 1; i + 1 < b[0].points.size(); ++i)
        EXPECT_LT(glm::distance(a[0].points[i + 20].at, b[0].points[i].at), 1e-3);
}

TEST(Ink, GoesOverALineThreeTimesWithAPencil)
{
    std::vector<Stroke> strokes = two_lines();
    for (StrokePoint& point : strokes[0].points) point.p = {point.at / 4.0f, 7};
    const std::vector<InkedLine> lines = inked(strokes, {.taper = 0, .pencil = 1});
    ASSERT_EQ(lines.size(), 3u);
    for (const InkedLine& line : lines) {
        EXPECT_EQ(line.id, 0xabcu);
        EXPECT_LT(line.opacity, 1);
        EXPECT_FALSE(line.is_even());
    }
}

} // namespace
} // namespace trivar::testing
