// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/profile.h"

#include "core/base/rejected.h"
#include "core/placement/embed.h"
#include "core/spline/curve.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
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
    refuses({{0, 1}, {0.5, std::nan("")}, {1, 1}}, "the factor not a number");
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

const std::vector<glm::dvec2> crown{{0, 0.4}, {0.5, 1.5}, {1, 0.4}};
const std::vector<glm::dvec2> flat_below{{0, 0}, {0.4, 0.1}, {0.7, 0.8}, {1, 1}};

TEST(Rise, AscendsStrictlyAndIsItselfWithoutPoints)
{
    const Knots above = Knots::uniform(4, 7);
    const Rise rise(flat_below, above);
    double before = -1e-9;
    for (int i = 0; i <= 200; ++i) {
        const double w = i / 200.0;
        EXPECT_GT(rise.at(w), before) << w;
        EXPECT_NEAR(rise.w_at(rise.at(w)), w, 1e-9);
        before = rise.at(w);
        EXPECT_EQ(Rise({}, above).at(w), w);
        EXPECT_EQ(Rise({{0, 0}, {0.3, 0.3}, {1, 1}}, above).at(w), w);
    }
    EXPECT_EQ(rise.at(0), 0);
    EXPECT_EQ(rise.at(1), 1);
    const auto refuses = [](const std::vector<glm::dvec2>& points, const char* words) {
        EXPECT_THAT([&] { check_rise(points, "the rise"); },
                    ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refuses({{0, 0}, {0.5, 0.6}, {0.7, 0.6}, {1, 1}}, "rise by at least 0.001");
    refuses({{0, 0.1}, {1, 1}}, "from 0 at the bottom");
    refuses({{0, 0}, {1, 0.9}}, "to 1 at the top");
}

TEST(Place, IsTheSameToTheBitWithProfilesThatChangeNothing)
{
    for (const double offset : {0.0, 1.0}) {
        const PlacementParameters none{.offset = offset};
        PlacementParameters even = none;
        even.width_profile = even.height_profile = {{0, 1}, {0.3, 1}, {1, 1}};
        even.height_across = {{0, 1}, {1, 1}};
        even.rise_profile = {{0, 0}, {0.2, 0.2}, {1, 1}};
        EXPECT_EQ(over_waves(even).volume, over_waves(none).volume);
    }
}

TEST(Place, LiesOnTheSceneWithTheLevelAskedFor)
{
    for (const double offset : {0.0, 1.0})
        for (const double level : {0.0, 0.3, 1.0}) {
            PlacementParameters p{.height = 0.1, .offset = offset};
            p.height_across = crown;
            p.rise_profile = flat_below;
            p.contact_level = level;
            const Placement out = over_waves(p);
            EXPECT_EQ(out.ground, level);
            EXPECT_GT(out.report.smallest_jacobian, 0);
            for (int i = 0; i <= 30; ++i)
                for (int j = 0; j <= 10; ++j) {
                    const glm::dvec2 uv(i / 30.0, j / 10.0);
                    EXPECT_LT(glm::distance(evaluate(out.volume, {uv.x, uv.y, level}).value,
                                            evaluate(out.contact, uv).value),
                              1e-12);
                }
        }
}

TEST(Place, HasTheHeightsOfBothProfilesAtItsNodesAndDoesNotFold)
{
    PlacementParameters p{.height = 0.1};
    p.height_profile = {{0, 0.5}, {0.4, 1.4}, {1, 0.3}};
    p.height_across = crown;
    p.rise_profile = flat_below;
    const Placement out = over_waves(p);
    const Profile along(p.height_profile), across(p.height_across);
    const auto& axes = out.contact.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j) {
            const double u = axes[0].greville(i), v = axes[1].greville(j);
            const glm::dvec3 floor = evaluate(out.volume, {u, v, 0}).value;
            EXPECT_NEAR(glm::distance(evaluate(out.volume, {u, v, 1}).value, floor),
                        0.1 * along.at(u) * across.at(v), 1e-12);
        }
    for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 20; ++j)
            for (int k = 0; k <= 8; ++k) {
                const auto f = evaluate(out.volume, {i / 60.0, j / 20.0, k / 8.0}, 1).first;
                EXPECT_GT(glm::determinant(glm::dmat3(f[0], f[1], f[2])), 0);
            }
}

TEST(Place, StaysPositiveWhereAHeightFallsOff)
{
    PlacementParameters p{.height = 0.1, .orders = {4, 4, 3}};
    p.height_profile = {{0, 1}, {0.5, 20}, {0.51, 0.02}, {0.52, 0.02}, {1, 1}};
    const Placement out = over_waves(p);
    for (int i = 0; i <= 400; ++i) {
        const auto f = evaluate(out.volume, {i / 400.0, 0.5, 0.5}, 1).first;
        EXPECT_GT(glm::determinant(glm::dmat3(f[0], f[1], f[2])), 0) << i;
    }
}

TEST(Place, LaysTheLongerSideOfAModelAlongTheStrokeWithItsFrontAhead)
{
    const Box fox{{-0.1, -0.8, 0}, {0.1, 0.7, 0.8}};
    const PlacementParameters p = lengthwise({}, fox);
    EXPECT_EQ(model_frame(p, fox).turn * glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(model_frame(p, fox).turn * glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1));
    EXPECT_FALSE(looks_back(p));
    EXPECT_EQ(lengthwise({}, snake_box()), PlacementParameters{});
    EXPECT_EQ(lengthwise({}, Box{{0, 0, 0}, {1, 1, 1}}), PlacementParameters{});
}

TEST(Place, LaysEverySideOfTheModelOnTheScene)
{
    const Box box = snake_box();
    std::vector<glm::dmat3> seen;
    for (int side = 0; side < 6; ++side)
        for (int quarters = 0; quarters < 4; ++quarters) {
            const Lying lying{static_cast<Underside>(side), quarters};
            const PlacementParameters p = with_lying({}, lying);
            EXPECT_EQ(lying_of(p), lying);
            const ModelFrame frame = model_frame(p, box);
            EXPECT_EQ(glm::determinant(frame.turn), 1);
            EXPECT_THAT(seen, Not(Contains(frame.turn)));
            seen.push_back(frame.turn);
            // Away from the scene, in the model's own axes, by sides in their order.
            constexpr std::array<glm::dvec3, 6> away{
                {{0, 0, 1}, {0, 1, 0}, {0, 0, -1}, {0, -1, 0}, {-1, 0, 0}, {1, 0, 0}}};
            EXPECT_EQ(frame.turn * away.at(static_cast<std::size_t>(side)), glm::dvec3(0, 0, 1));
        }
    EXPECT_EQ(with_lying({}, {}), PlacementParameters{});
    const PlacementParameters front = with_lying({}, {Underside::front, 0});
    const ModelFrame frame = model_frame(front, box);
    EXPECT_EQ(frame.box.size().z, box.size().x); // it stands on its nose
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
