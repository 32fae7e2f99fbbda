// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/fit.h"

#include "core/base/rejected.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::all_axes;
using testing::inside;
using testing::Noise;
using testing::random_curve;

double largest_distance(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b)
{
    double largest = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, glm::distance(a[i], b[i]));
    return largest;
}

std::vector<glm::dvec2> sampled(const Curve<glm::dvec2>& c, const std::vector<double>& parameters)
{
    std::vector<glm::dvec2> out;
    for (const double t : parameters) out.push_back(evaluate(c, t).value);
    return out;
}

// Sum of squared distances plus mu times the integral, by the midpoint rule.
double energy(const Curve<glm::dvec2>& c, const std::vector<double>& t,
              const std::vector<glm::dvec2>& q, double mu)
{
    double sum = 0;
    for (std::size_t s = 0; s < t.size(); ++s) {
        const glm::dvec2 off = evaluate(c, t[s]).value - q[s];
        sum += glm::dot(off, off);
    }
    const int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const glm::dvec2 bend = evaluate(c, (i + 0.5) / steps, 2).second;
        sum += mu * glm::dot(bend, bend) / steps;
    }
    return sum;
}

TEST(Interpolation, IsExactAtTheGrevilleSitesOfEveryKindOfAxis)
{
    for (const Knots& knots : all_axes()) {
        if (knots.closure() == Closure::open && knots.values()[0] != knots.begin()) continue;
        const auto truth = random_curve<glm::dvec2>(knots);
        const auto sites = greville_sites(knots);
        const auto c = interpolate(knots, truth.points);
        EXPECT_LT(largest_distance(sampled(c, sites), truth.points), 1e-13) << knots.order();
        const auto again = interpolate(knots, sampled(truth, sites));
        EXPECT_LT(largest_distance(again.points, truth.points), 1e-12) << knots.order();
    }
}

TEST(Interpolation, ReproducesACubicMapOnAnyGrid)
{
    const auto map = [](glm::dvec3 p) {
        return glm::dvec3(p.x * p.x * p.x - p.y, p.y * p.z + p.x, p.z * p.z * p.y + 2);
    };
    const std::array<Knots, 3> axes{Knots::uniform(4, 7), testing::uneven_knots(5),
                                    Knots::uniform(4, 4)};
    std::vector<glm::dvec3> values;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1]))
            for (const double w : greville_sites(axes[2])) values.push_back(map({u, v, w}));
    const auto f = interpolate(axes, values);
    Noise noise;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
        EXPECT_LT(glm::distance(evaluate(f, p).value, map(p)), 1e-13);
    }
}

TEST(Interpolation, RefusesAxesWithTwoControlPointsInOnePlace)
{
    const Knots torn = Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1});
    EXPECT_THROW(interpolation_map(torn), Rejected);
    EXPECT_THROW(interpolate(Knots::uniform(3, 5), std::vector<double>(4)), Rejected);
}

TEST(Fit, FindsTheSplineItsSamplesCameFrom)
{
    for (const Knots& knots : all_axes()) {
        const auto truth = random_curve<glm::dvec2>(knots);
        auto t = inside(knots, 60);
        if (knots.closure() != Closure::open) t.pop_back();
        const auto c = fit(knots, t, sampled(truth, t));
        EXPECT_LT(largest_distance(c.points, truth.points), 1e-9) << knots.order();
    }
}

TEST(Fit, ReproducesPolynomialsWhateverTheWeights)
{
    const Knots knots = testing::uneven_knots(4);
    Noise noise;
    std::vector<double> t = inside(knots, 40), weights;
    std::vector<double> values;
    for (const double s : t) {
        weights.push_back(noise.between(0.1, 3));
        values.push_back(1 + s * (2 - s * (3 - 5 * s)));
    }
    const auto c = fit(knots, t, values, {.weights = weights});
    for (const double s : inside(knots, 101))
        EXPECT_NEAR(evaluate(c, s).value, 1 + s * (2 - s * (3 - 5 * s)), 1e-12);
}

TEST(Fit, PassesThroughItsEndsWhenAsked)
{
    Noise noise;
    std::vector<glm::dvec2> q;
    for (int i = 0; i < 50; ++i) q.push_back(glm::dvec2(i, 10 * std::sin(0.2 * i)) + noise.vec2());
    const auto t = chord_length_parameters(q);
    const Knots knots = Knots::uniform(4, 8);
    const auto c = fit(knots, t, q, {.smoothing = 1e-3, .ends = true});
    EXPECT_EQ(evaluate(c, 0).value, q.front());
    EXPECT_EQ(evaluate(c, 1).value, q.back());
    EXPECT_THROW(fit(Knots::periodic(4, 8), t, q, {.ends = true}), Rejected);
}

TEST(Fit, MinimisesDistanceAndBending)
{
    Noise noise;
    const Knots knots = Knots::uniform(4, 9);
    const auto t = inside(knots, 30);
    std::vector<glm::dvec2> q;
    for (std::size_t i = 0; i < t.size(); ++i) q.push_back(noise.vec2());
    const double mu = 1e-4;
    const auto best = fit(knots, t, q, {.smoothing = mu});
    const double least = energy(best, t, q, mu);
    for (int trial = 0; trial < 20; ++trial) {
        auto other = best;
        for (auto& p : other.points) p += 0.05 * noise.vec2();
        EXPECT_GT(energy(other, t, q, mu), least);
    }
}

TEST(Fit, OfStrongSmoothingIsTheStraightLine)
{
    const Knots knots = Knots::uniform(4, 12);
    const auto t = inside(knots, 40);
    std::vector<double> q;
    for (const double s : t) q.push_back(s * s);
    const auto c = fit(knots, t, q, {.smoothing = 1e6});
    EXPECT_NEAR(evaluate(c, 0.3, 2).second, 0, 1e-5);
}

TEST(Fit, SmoothingDeterminesWhatSamplesDoNot)
{
    const Knots knots = Knots::uniform(4, 20);
    const std::vector<double> t{0, 0.3, 0.6, 1};
    const std::vector<double> q{0, 3, 6, 10};
    EXPECT_THROW(fit(knots, t, q), Rejected);
    const auto c = fit(knots, t, std::vector<double>{0, 3, 6, 10}, {.smoothing = 1e-6});
    EXPECT_NEAR(evaluate(c, 0.3).value, 3, 1e-2);
}

TEST(Fit, OfACurveIsWhatTheTableOfAllItsSamplesGives)
{
    Noise noise;
    for (const Knots& knots : all_axes()) {
        const auto t = inside(knots, 50);
        std::vector<double> weights;
        std::vector<glm::dvec2> q;
        for (std::size_t s = 0; s < t.size(); ++s) {
            weights.push_back(noise.between(0.5, 2));
            q.push_back(noise.vec2());
        }
        const bool clamped = knots.closure() == Closure::open && knots.values()[0] == knots.begin();
        const FitOptions options{.smoothing = 1e-5, .ends = clamped, .weights = weights};
        const AxisMap table = least_squares_map(knots, t, options);
        const auto points =
            applied(table, {50, knots.closure()}, std::span<const glm::dvec2>(q), 1);
        EXPECT_LT(largest_distance(fit(knots, t, q, options).points, points), 1e-9);
    }
}

TEST(Fit, OfAGridFindsTheTensorItCameFrom)
{
    Noise noise;
    const std::array<Knots, 3> axes{Knots::uniform(3, 5), Knots::periodic(4, 6),
                                    Knots::uniform(2, 3)};
    Trivariate<double> truth{axes, std::vector<double>(5 * 6 * 3)};
    for (double& p : truth.points) p = noise();
    std::array<std::vector<double>, 3> t{inside(axes[0], 9), inside(axes[1], 14),
                                         inside(axes[2], 5)};
    t[1].pop_back();
    std::vector<double> q;
    for (const double u : t[0])
        for (const double v : t[1])
            for (const double w : t[2]) q.push_back(evaluate(truth, {u, v, w}).value);
    const auto f = fit(axes, t, q);
    for (std::size_t i = 0; i < truth.points.size(); ++i)
        EXPECT_NEAR(f.points[i], truth.points[i], 1e-12);
}

TEST(Fit, RoundAMoebiusBandFindsTheMirroredPoints)
{
    Noise noise;
    const std::array<Knots, 2> axes{Knots::periodic(3, 6, 0, 1, Closure::twisted),
                                    Knots::uniform(3, 4)};
    Surface<glm::dvec3> truth{axes, {}};
    for (int i = 0; i < 24; ++i) truth.points.push_back(noise.vec3());
    std::vector<glm::dvec3> values;
    for (const double u : greville_sites(axes[0]))
        for (const double v : greville_sites(axes[1]))
            values.push_back(evaluate(truth, {u, v}).value);
    const auto same = interpolate(axes, values);
    for (const double u : {0.0, 0.1, 0.97, 1.2})
        for (const double v : {0.0, 0.3, 1.0})
            EXPECT_LT(glm::distance(evaluate(same, {u, v}).value, evaluate(truth, {u, v}).value),
                      1e-13);
}

TEST(Fit, RejectsSamplesThatAreNotNumbers)
{
    const Knots knots = Knots::uniform(3, 4);
    const std::vector<double> t{0, 0.2, 0.5, 0.8, std::nan("")}, w{1, 1, 1, 1, -1};
    EXPECT_THROW(least_squares_map(knots, t), Rejected);
    EXPECT_THROW(least_squares_map(knots, inside(knots, 5), {.weights = w}), Rejected);
    EXPECT_THROW(least_squares_map(knots, inside(knots, 5), {.smoothing = -1}), Rejected);
    EXPECT_THROW(least_squares_map(knots, inside(knots, 6), {.weights = w}), Rejected);
    EXPECT_THROW(least_squares_map(knots, {}), Rejected);
    const std::vector<glm::dvec2> still(5, glm::dvec2(3));
    EXPECT_THROW(chord_length_parameters(still), Rejected);
    EXPECT_THROW(chord_length_parameters(std::vector<glm::dvec2>{}), Rejected);
}

TEST(ChordLength, SharesTheDomainByDistance)
{
    const std::vector<glm::dvec2> p{{0, 0}, {3, 0}, {3, 1}};
    EXPECT_EQ(chord_length_parameters(p), (std::vector<double>{0, 0.75, 1}));
}

TEST(ParameterCorrection, BringsParametersToTheFeetOfTheirPoints)
{
    const auto c = random_curve<glm::dvec2>(Knots::uniform(4, 6));
    std::vector<double> truth, start;
    for (int i = 1; i < 20; ++i) {
        truth.push_back(i / 20.0);
        start.push_back(i / 20.0 + 0.002 * (i % 2 == 0 ? 1 : -1));
    }
    const auto points = sampled(c, truth);
    auto t = start;
    for (int step = 0; step < 5; ++step) t = corrected_parameters(c, t, points);
    for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(t[i], truth[i], 1e-10);
}

} // namespace
} // namespace trivar
