// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/placement/sketch.h"
#include "core/placement/strip.h"
#include "core/spline/fit.h"
#include "tests/placement/scenes.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void expect_no_fold(const Strip& strip)
{
    for (int i = 5; i < 495; ++i)
        for (const double v : {0.0, 0.5, 1.0}) {
            const double a = i / 500.0, e = 1e-5;
            const glm::dvec2 u = strip.at(a + e, v) - strip.at(a - e, v);
            const glm::dvec2 w = strip.at(a, 1) - strip.at(a, 0);
            EXPECT_LT(u.x * w.y - u.y * w.x, 0) << a << " " << v; // y goes down
        }
}

TEST(Sketch, AKnownCubicIsRecovered)
{
    const Curve<glm::dvec2> cubic{Knots::uniform(4, 4),
                                  {{100, 500}, {500, 100}, {900, 700}, {1300, 400}}};
    std::vector<glm::dvec2> points;
    std::vector<double> t;
    for (int i = 0; i <= 200; ++i) {
        t.push_back(i / 200.0);
        points.push_back(evaluate(cubic, t.back()).value);
    }
    const Curve<glm::dvec2> again = fit(cubic.knots, t, points, {.smoothing = 1e-13, .ends = true});
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(glm::length(again.points[i] - cubic.points[i]), 0, 1e-6);
    // The points alone, whose parameters are not known, give it within the tolerance.
    const Curve<glm::dvec2> fitted = fit_sketch(points, 0.01);
    for (const glm::dvec2& p : points) {
        double nearest = 1e9;
        for (int i = 0; i <= 4000; ++i)
            nearest = std::min(nearest, glm::length(evaluate(fitted, i / 4000.0).value - p));
        EXPECT_LT(nearest, 0.2);
    }
}

TEST(Sketch, NoiseIsSmoothedAndATighterToleranceNeverTakesFewerControlPoints)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 1);
    std::vector<glm::dvec2> clean, noisy;
    for (int i = 0; i <= 300; ++i) {
        clean.emplace_back(100 + 4 * i, 500 + 200 * std::sin(0.02 * i));
        noisy.push_back(clean.back() + glm::dvec2(noise(random), noise(random)));
    }
    const Curve<glm::dvec2> curve = fit_sketch(noisy, 4);
    double squares = 0;
    for (const glm::dvec2& p : clean) {
        double nearest = 1e9;
        for (int i = 0; i <= 3000; ++i)
            nearest = std::min(nearest, glm::length(evaluate(curve, i / 3000.0).value - p));
        squares += nearest * nearest;
    }
    EXPECT_LT(std::sqrt(squares / 301), 1.5);
    int before = 0;
    for (const double tolerance : {16.0, 8.0, 4.0, 2.0, 1.0}) {
        const int count = fit_sketch(noisy, tolerance).knots.count();
        EXPECT_GE(count, before);
        before = count;
    }
}

TEST(Sketch, AStrokeThatEndsWhereItBeganIsASmoothRing)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 200; ++i) { // ends 6 pixels before its start
        const double t = (6.2831853 - 0.03) * i / 199;
        points.emplace_back(600 + 200 * std::cos(t), 500 + 200 * std::sin(t));
    }
    const Curve<glm::dvec2> ring = fit_sketch(points, 0.5);
    const CurveJet<glm::dvec2> first = evaluate(ring, 1e-9, 2), last = evaluate(ring, 1 - 1e-9, 2);
    EXPECT_LT(glm::length(first.value - last.value), 1e-5);
    EXPECT_LT(glm::length(first.first - last.first), 1e-3 * glm::length(first.first));
    EXPECT_LT(glm::length(first.second - last.second), 1e-3 * glm::length(first.second));
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(glm::length(evaluate(ring, i / 1000.0).value - glm::dvec2(600, 500)), 200, 0.7);
    // A wide strip inside it is narrowed alike on both sides of the seam.
    const Strip strip = strip_round(ring, std::vector<double>(129, 230));
    EXPECT_EQ(strip.left_px.front(), strip.left_px.back());
    EXPECT_EQ(strip.right_px.front(), strip.right_px.back());
    points.resize(190); // 63 pixels short of a ring
    EXPECT_GT(glm::length(evaluate(fit_sketch(points, 0.5), 0).value - points.back()), 60);
}

TEST(Sketch, ACornerIsFollowedWithinTheToleranceAndTheStripRoundItDoesNotFold)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 100; ++i) points.emplace_back(100 + 4 * i, 500);
    for (int i = 1; i <= 75; ++i) points.emplace_back(500, 500 - 4 * i);
    const Curve<glm::dvec2> curve = fit_sketch(points);
    for (const glm::dvec2& p : points) {
        double nearest = 1e9;
        for (int i = 0; i <= 4000; ++i)
            nearest = std::min(nearest, glm::length(evaluate(curve, i / 4000.0).value - p));
        EXPECT_LT(nearest, 2.5) << p.x << " " << p.y;
    }
    expect_no_fold(strip_round(curve, std::vector<double>(129, 60)));
}

TEST(Strip, LeftIsLeftAsTheUserSeesIt)
{
    const Strip strip = strip_round(fit_sketch({{100, 500}, {900, 500}}), {50, 50});
    EXPECT_NEAR(strip.at(0.5, 1).y, 450, 1e-9);
    EXPECT_NEAR(strip.at(0.5, 0).y, 550, 1e-9);
}

TEST(Strip, DoesNotFoldWhereTheStrokeTurnsTighterThanItIsWide)
{
    // Half an ellipse with a smallest radius of 50 pixels and a strip twice as wide as that.
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 200; ++i) {
        const double t = 3.14159265 * i / 200;
        points.emplace_back(500 - 200 * std::cos(t), 500 - 400 * std::sin(t));
    }
    const Strip strip = strip_round(fit_sketch(points, 0.5), std::vector<double>(200, 150));
    EXPECT_GT(std::count(strip.narrowed.begin(), strip.narrowed.end(), 1), 0);
    expect_no_fold(strip);
}

// A hand's stroke along straight lines: a point every five pixels.
std::vector<glm::dvec2> polyline(const std::vector<glm::dvec2>& corners)
{
    std::vector<glm::dvec2> out{corners.front()};
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const int steps = static_cast<int>(glm::length(corners[k] - corners[k - 1]) / 5) + 1;
        for (int i = 1; i <= steps; ++i)
            out.push_back(glm::mix(corners[k - 1], corners[k], static_cast<double>(i) / steps));
    }
    return out;
}

TEST(Strip, TurnsWithinItsWidthAsMuchAsItsMiddleLineDoes)
{
    constexpr double pi = 3.14159265358979;
    std::vector<glm::dvec2> arc;
    for (int i = 0; i <= 200; ++i)
        arc.push_back(glm::dvec2(500, 500) +
                      200.0 * glm::dvec2(std::cos(0.02 * i), std::sin(0.02 * i)));
    const auto turn = [](const std::vector<glm::dvec2>& points, double half_width_px) {
        return sharpest_turn(fit_sketch(points), std::vector<double>(129, half_width_px));
    };
    EXPECT_NEAR(turn(arc, 50), 100.0 / 200, 0.06);
    EXPECT_NEAR(turn(arc, 100), 200.0 / 200, 0.06);
    EXPECT_NEAR(turn(polyline({{100, 500}, {500, 500}, {500, 100}}), 40), pi / 2, 0.2);
    EXPECT_GT(turn(polyline({{100, 500}, {500, 500}, {505, 520}, {100, 525}}), 60), 2.8);
    EXPECT_NEAR(turn({{100, 500}, {500, 300}}, 60), 0, 1e-6);
}

TEST(BadStroke, IsRejectedWithWhatToDo)
{
    const Camera camera = from_above();
    const RayScene scene = scene_of(height_field(1, 4, [](double, double) { return 0; }));
    const auto placing = [&](const std::vector<glm::dvec2>& px, const PlacementParameters& p = {}) {
        return [&, px, p] {
            Timings timings;
            place(stroke(camera, px), p, snake_box(), scene, timings);
        };
    };
    const auto says = [](const char* text) { return ThrowsMessage<Rejected>(HasSubstr(text)); };
    const double nan = std::nan("");
    EXPECT_THAT(placing({{700, 500}, {700, 500}}), says("click"));
    EXPECT_THAT(placing({{700, 500}, {704, 500}}), says("too short"));
    EXPECT_THAT(placing({{700, 500}, {1600, 500}}), says("leaves the picture"));
    EXPECT_THAT(placing({{50, 50}, {300, 50}}), says("meets nothing"));
    EXPECT_THAT(placing({{700, nan}, {900, 500}}), says("not a number"));
    EXPECT_THAT(placing({{600, 500}, {900, 500}}, {.width = 100}),
                says("more than the picture shows"));
    EXPECT_THAT(placing({{600, 500}, {900, 500}}, {.width = nan}), says("width"));
    EXPECT_THAT(placing({{600, 500}, {900, 500}}, {.height = -1}), says("height"));
    EXPECT_THAT(placing({{600, 500}, {900, 500}}, {.grid = {2, 9, 4}}), says("control points"));
    EXPECT_THAT(placing({{600, 500}, {900, 500}}, {.start = 0.5, .fill = 0.6}), says("fill"));
    EXPECT_NO_THROW(placing({{600, 500}, {900, 500}})());
    // There and back again leaves no room for a strip; round a corner there is some.
    EXPECT_THAT(placing(polyline({{600, 500}, {900, 500}, {905, 530}, {600, 540}}), {.width = 0.3}),
                says("turn is too tight"));
    EXPECT_NO_THROW(placing(polyline({{600, 500}, {800, 500}, {800, 700}}), {.width = 0.3})());
}

} // namespace
} // namespace trivar
