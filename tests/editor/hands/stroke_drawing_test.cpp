// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/stroke_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

std::vector<StrokeSample> to(std::vector<glm::dvec2> places, double time_s = 0)
{
    std::vector<StrokeSample> out;
    for (const glm::dvec2& p : places) out.push_back({p, time_s += 0.01, 1});
    return out;
}

TEST(StrokeDrawing, KeepsWhatTheHandDidFromTimeZero)
{
    StrokeDrawing stroke;
    stroke.begin({}, 10);
    EXPECT_TRUE(stroke.take(to({{5, 5}, {9, 5}, {9, 5}, {20, 9}}, 10), {.pressure = 0.25}));
    ASSERT_EQ(stroke.sketch().samples.size(), 3u); // a mouse that rests is no sample
    EXPECT_NEAR(stroke.sketch().samples.front().time_s, 0.01, 1e-12);
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(20, 9));
    EXPECT_EQ(stroke.sketch().samples.back().pressure, 0.25);
    EXPECT_FALSE(stroke.is_click());
    EXPECT_FALSE(stroke.take({}, {}));
}

TEST(StrokeDrawing, LeavesOutWhatIsOutsideThePicture)
{
    StrokeDrawing stroke;
    Camera camera;
    camera.size_px = {100, 80};
    stroke.begin(camera, 0);
    stroke.take(to({{50, 50}, {90, 79}, {101, 70}, {90, 81}, {-1, 50}, {20, 30}}), {});
    EXPECT_EQ(stroke.sketch().samples.size(), 3u);
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(20, 30));
}

TEST(StrokeDrawing, IsStraightWhileAskedToBe)
{
    StrokeDrawing stroke;
    stroke.begin({}, 0);
    stroke.take(to({{0, 0}, {50, 20}}), {});
    stroke.take(to({{60, 90}, {80, 10}, {250, 20}}), {.straight = true});
    for (const StrokeSample& s : stroke.sketch().samples)
        if (s.p_px.x > 50) {
            EXPECT_NEAR(s.p_px.y, 20, 1e-9);
        }
    stroke.take(to({{260, 60}, {260, 100}}), {});
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(260, 100));
    const auto& samples = stroke.sketch().samples;
    EXPECT_TRUE(std::ranges::any_of(
        samples, [](const StrokeSample& s) { return s.p_px == glm::dvec2(250, 20); }));
}

TEST(StrokeDrawing, ARingClosesWhereItIsAskedToAndOpensAgain)
{
    StrokeDrawing stroke;
    stroke.begin({}, 0);
    stroke.take(to({{0, 0}, {200, 0}, {200, 200}, {0, 200}, {0, 20}}), {.close = true});
    EXPECT_TRUE(stroke.is_ring());
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(0, 0));
    stroke.take({}, {});
    EXPECT_FALSE(stroke.is_ring());
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(0, 20));
    stroke.take(to({{0, 10}}), {.close = true});
    EXPECT_TRUE(stroke.is_ring());
    stroke.take(to({{0, 100}}), {.close = true}); // the hand goes on
    EXPECT_FALSE(stroke.is_ring());
    EXPECT_EQ(stroke.sketch().samples.back().p_px, glm::dvec2(0, 100));
}

} // namespace
} // namespace trivar
