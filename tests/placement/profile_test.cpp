// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/profile.h"

#include "core/base/rejected.h"
#include "core/spline/curve.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

const std::vector<glm::dvec2> leaf{{0, 0.3}, {0.2, 1.6}, {0.55, 1.2}, {0.9, 0.9}, {1, 0.1}};

TEST(Profile, IsTheCurveOverItsControlPoints)
{
    const Profile profile(leaf);
    const Curve<glm::dvec2> curve{Knots::uniform(3, 5), leaf};
    for (int i = 0; i <= 1000; ++i) {
        const glm::dvec2 p = evaluate(curve, i / 1000.0).value;
        EXPECT_NEAR(profile.at(p.x), p.y, 1e-12) << p.x;
    }
    EXPECT_EQ(profile.at(-1), 0.3);
    EXPECT_EQ(profile.at(2), 0.1);
    EXPECT_EQ(Profile().at(0.3), 1);
    EXPECT_NEAR(Profile({{0, 1}, {1, 3}}).at(0.25), 1.5, 1e-15);
}

TEST(Profile, NeverLeavesTheRangeOfItsFactors)
{
    const Profile profile(leaf);
    for (int i = 0; i <= 1000; ++i) {
        EXPECT_GE(profile.at(i / 1000.0), 0.1);
        EXPECT_LE(profile.at(i / 1000.0), profile.largest());
    }
}

TEST(Profile, SaysWhatIsWrong)
{
    const auto refuses = [](const std::vector<glm::dvec2>& points, const char* words) {
        EXPECT_THAT([&] { check_profile(points, "the width"); },
                    ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refuses({{0, 1}}, "needs two");
    refuses({{0.1, 1}, {1, 1}}, "begin at 0");
    refuses({{0, 1}, {0.5, 1}, {0.5, 2}, {1, 1}}, "ascending");
    refuses({{0, 1}, {1, 0}}, "the factor 0");
    refuses({{0, 1}, {0.5, std::nan("")}, {1, 1}}, "the factor nan");
    refuses(std::vector<glm::dvec2>(65, {0, 1}), "at most 64");
}

TEST(Place, FollowsTheProfilesOfWidthAndHeight)
{
    const RayScene ground = scene_of(height_field(20, 1, [](double, double) { return 0.0; }));
    Timings timings;
    PlacementParameters p{.width = 0.3, .height = 0.2};
    p.width_profile = leaf;
    p.height_profile = {{0, 0.5}, {1, 1.5}};
    const Placement out =
        place(stroke(from_above(), {{200, 500}, {1300, 500}}), p, snake_box(), ground, timings);
    const Profile width(leaf);
    for (int i = 1; i < 10; ++i) {
        const double u = i / 10.0;
        const auto s = evaluate(out.contact, {u, 0.5}, 1);
        // The surface has a control point every thirtieth of the stroke.
        EXPECT_NEAR(glm::length(s.v), 0.3 * width.at(u), 0.01) << u;
        const auto at = [&](double w) { return evaluate(out.volume, {u, 0.5, w}).value; };
        EXPECT_NEAR(at(1).z - at(0).z, 0.2 * (0.5 + u), 1e-9) << u;
    }
    EXPECT_EQ(out.nodes.size(), out.contact.points.size());
    for (const StripNode& node : out.nodes) {
        EXPECT_EQ(node.contact, Contact::touches);
        EXPECT_FALSE(node.folds);
        EXPECT_NEAR(node.spread, 1, 0.2);
    }
}

TEST(Place, TellsWhichNodesBridgeAndWhichMiss)
{
    const RayScene two = scene_of(
        height_field(2.4, 24, [](double x, double) { return std::abs(x) < 0.25 ? -1.0 : 0.0; }));
    Timings timings;
    const Placement out = place(stroke(from_above(4), {{250, 500}, {1100, 500}}),
                                {.width = 0.2, .height = 0.2}, snake_box(), two, timings);
    for (const StripNode& node : out.nodes) {
        const double x = node.p_world.x;
        if (std::abs(x) < 0.2) {
            EXPECT_EQ(node.contact, Contact::bridges) << x;
        } else if (x > 1.25) {
            EXPECT_EQ(node.contact, Contact::missed) << x;
        } else if (x < -0.9 && x > -1.1) {
            EXPECT_EQ(node.contact, Contact::touches) << x;
        }
    }
}

std::vector<StrokeSample> hand(const std::function<double(double)>& speed)
{
    std::vector<StrokeSample> out;
    double x = 0;
    for (int i = 0; x < 1000; ++i) {
        out.push_back({{x, 300}, 0.01 * i, 0.5 * (1 - x / 2000)});
        x += 0.01 * speed(x);
    }
    return out;
}

TEST(Brush, IsWiderWhereTheHandIsSlower)
{
    const std::vector<StrokeSample> slow_end =
        hand([](double x) { return x < 500 ? 1200.0 : 300.0; });
    const Profile profile(brush_profile(slow_end, Brush::speed));
    EXPECT_NEAR(profile.at(0.9) / profile.at(0.1), 2, 0.1); // a quarter of the speed
    EXPECT_THAT(brush_profile(hand([](double) { return 500.0; }), Brush::speed), IsEmpty());
    EXPECT_THAT(brush_profile(slow_end, Brush::even), IsEmpty());
    const Profile pressed(brush_profile(slow_end, Brush::pressure));
    EXPECT_NEAR(pressed.at(0), 1, 0.01);
    EXPECT_NEAR(pressed.at(1), 0.5, 0.01);
}

TEST(Brush, TakesAnyStroke)
{
    std::vector<StrokeSample> frozen = hand([](double) { return 500.0; });
    for (StrokeSample& s : frozen) s.time_s = 0;
    for (const Brush brush : {Brush::speed, Brush::pressure}) {
        EXPECT_NO_THROW(Profile(brush_profile(frozen, brush)));
        EXPECT_THAT(brush_profile({}, brush), IsEmpty());
        EXPECT_THAT(brush_profile({{{5, 5}, 0, 1}, {{5, 5}, 1, 1}}, brush), IsEmpty());
        EXPECT_NO_THROW(Profile(brush_profile({{{5, 5}, 0, 1}, {{9, 5}, 1, 0}}, brush)));
    }
}

} // namespace
} // namespace trivar
