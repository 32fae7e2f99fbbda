// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/redraw.h"

#include "tests/placement/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::IsEmpty;

std::vector<StrokeSample> piece(const std::vector<glm::dvec2>& corners)
{
    return stroke(from_above(), corners).samples;
}

const Sketch straight = stroke(from_above(), {{100, 500}, {1100, 500}});

bool passes(const Sketch& sketch, glm::dvec2 p)
{
    return nearest_share(sketch, p).distance_px < 1e-9;
}

void expect_times_ascend(const Sketch& sketch)
{
    for (std::size_t i = 1; i < sketch.samples.size(); ++i)
        EXPECT_GE(sketch.samples[i].time_s, sketch.samples[i - 1].time_s);
}

TEST(Redraw, APieceThatComesBackReplacesWhatIsBetween)
{
    const std::vector<glm::dvec2> hill{{400, 502}, {600, 300}, {803, 498}};
    for (const bool backwards : {false, true}) {
        std::vector<glm::dvec2> corners = hill;
        if (backwards) std::reverse(corners.begin(), corners.end());
        const Sketch out = redrawn(straight, piece(corners), 10);
        EXPECT_EQ(out.samples.front().p_px, straight.samples.front().p_px);
        EXPECT_EQ(out.samples.back().p_px, straight.samples.back().p_px);
        EXPECT_TRUE(passes(out, {600, 300}));
        EXPECT_TRUE(passes(out, {200, 500}));
        EXPECT_TRUE(passes(out, {1000, 500}));
        EXPECT_FALSE(passes(out, {600, 500}));
        EXPECT_LT(nearest_share(out, {400, 502}).share, nearest_share(out, {803, 498}).share);
        expect_times_ascend(out);
    }
}

TEST(Redraw, AnyOtherReplacesTheRestOnItsSide)
{
    const Sketch onward = redrawn(straight, piece({{500, 500}, {700, 300}, {900, 100}}), 10);
    EXPECT_EQ(onward.samples.front().p_px, straight.samples.front().p_px);
    EXPECT_EQ(onward.samples.back().p_px, glm::dvec2(900, 100));
    EXPECT_FALSE(passes(onward, {800, 500}));
    const Sketch back = redrawn(straight, piece({{500, 500}, {300, 300}, {100, 100}}), 10);
    EXPECT_EQ(back.samples.front().p_px, glm::dvec2(100, 100));
    EXPECT_EQ(back.samples.back().p_px, straight.samples.back().p_px);
    EXPECT_FALSE(passes(back, {300, 500}));
    const Sketch longer = redrawn(straight, piece({{1100, 500}, {1400, 520}}), 10);
    EXPECT_TRUE(passes(longer, {100, 500}));
    EXPECT_EQ(longer.samples.back().p_px, glm::dvec2(1400, 520));
    const Sketch earlier = redrawn(straight, piece({{100, 500}, {20, 520}}), 10);
    EXPECT_EQ(earlier.samples.front().p_px, glm::dvec2(20, 520));
    EXPECT_TRUE(passes(earlier, {1000, 500}));
    for (const Sketch& out : {onward, back, longer, earlier}) expect_times_ascend(out);
}

TEST(Redraw, ALineSeenFromElsewhereGoesWhereItWasSeen)
{
    const RayScene ground = scene_of(height_field(20, 1, [](double, double) { return 0.0; }));
    const Camera above = from_above(), side = from_the_side();
    const std::vector<glm::dvec3> places{{-0.5, 0.1, 0}, {0.4, 0.2, 0}};
    const Sketch drawn = stroke_over(side, places);
    const std::vector<StrokeSample> seen = seen_from(above, side, drawn.samples, ground);
    ASSERT_EQ(seen.size(), drawn.samples.size());
    EXPECT_NEAR(glm::distance(seen.front().p_px, project(above, places[0]).p_px), 0, 1e-6);
    EXPECT_NEAR(glm::distance(seen.back().p_px, project(above, places[1]).p_px), 0, 1e-6);
    EXPECT_EQ(seen_from(side, side, drawn.samples, ground), drawn.samples);
    const Camera up{.eye = {0, 0, 1}, .target = {0, 0.1, 2}};
    EXPECT_THAT(seen_from(above, up, drawn.samples, ground), IsEmpty());
}

TEST(Deformation, GoesTheWholeWayWhereItIsHeldAndNotBeyondReach)
{
    const Sketch out = bent(straight, 0.5, {0, -80}, 0.2);
    EXPECT_TRUE(passes(out, {600, 420}) || nearest_share(out, {600, 420}).distance_px < 0.5);
    for (std::size_t i = 0; i < out.samples.size(); ++i) {
        const double moved = glm::distance(out.samples[i].p_px, straight.samples[i].p_px);
        const double away = std::abs(straight.samples[i].p_px.x - 600);
        if (away >= 200) {
            EXPECT_EQ(moved, 0);
        }
        EXPECT_LE(moved, 80);
    }
    EXPECT_EQ(bent(straight, 0.5, {0, 0}, 0.2), straight);
}

TEST(Deformation, ARingKeepsItsSeamClosed)
{
    std::vector<glm::dvec2> ring;
    for (int i = 0; i <= 72; ++i)
        ring.emplace_back(750 + 300 * std::cos(i * 0.0872664626),
                          500 + 300 * std::sin(i * 0.0872664626));
    const Sketch out = bent(stroke(from_above(), ring), 0, {50, 0}, 0.1);
    EXPECT_LT(glm::distance(out.samples.front().p_px, out.samples.back().p_px), 1);
    EXPECT_NEAR(out.samples.front().p_px.x, 1100, 1e-6);
}

TEST(NearestShare, IsTheShareOfTheLength)
{
    EXPECT_NEAR(nearest_share(straight, {350, 520}).share, 0.25, 1e-12);
    EXPECT_NEAR(nearest_share(straight, {350, 520}).distance_px, 20, 1e-12);
    EXPECT_NEAR(length_px(straight.samples), 1000, 1e-9);
}

} // namespace
} // namespace trivar
