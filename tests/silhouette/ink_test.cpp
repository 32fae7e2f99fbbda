// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/svg.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Two lines, the second one hidden, whose slopes and depths grow from 0 to 99.
std::vector<Stroke> two_lines()
{
    std::vector<Stroke> out(2);
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i);
        out[0].points.push_back({.at = {x, 10}, .depth = x, .slope = x});
        out[1].points.push_back({.at = {x, 20}, .depth = x, .slope = x});
    }
    out[0].edge = 0xabc;
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

TEST(Svg, HasALayerForEachLevelWithIdsThatStay)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.hidden = HiddenLines::dashed});
    const std::vector<DrawingLayer> layers{{"bone & skin", lines}, {"", {}}};
    const std::string text = svg_of(layers, {640, 480});
    EXPECT_THAT(text, HasSubstr("viewBox=\"0 0 640 480\""));
    EXPECT_THAT(text, HasSubstr("inkscape:label=\"bone &amp; skin\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin-sabc\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin-hidden\""));
    EXPECT_THAT(text, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(text, HasSubstr("<rect"));
    EXPECT_THAT(svg_of(layers, {640, 480}, std::nullopt), Not(HasSubstr("<rect")));
}

TEST(Svg, HasAPathForEachPieceOfOneColor)
{
    const std::string plain =
        svg_of(std::vector<DrawingLayer>{{"a", inked(two_lines(), {.taper = 0})}}, {100, 100});
    const std::string hues = svg_of(
        std::vector<DrawingLayer>{
            {"a", inked(two_lines(), {.color_by = LineColor::hue_by_slope, .taper = 0})}},
        {100, 100});
    const auto paths = [](const std::string& text) {
        std::size_t out = 0;
        for (std::size_t at = text.find("<path"); at != text.npos; at = text.find("<path", at + 1))
            ++out;
        return out;
    };
    EXPECT_EQ(paths(plain), 1u);
    EXPECT_GT(paths(hues), 20u);
    EXPECT_THAT(plain, HasSubstr("d=\"M0 10 1 10 2 10"));
}

} // namespace
} // namespace trivar::testing
