// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/refinement/truth.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

using namespace testing;
using enum BoundMethod;

constexpr std::array true_methods{thesis_right_angled, thesis,       barycentric,
                                  best_corner,         circumradius, waldron,
                                  net_affine,          composed_net, composed_net_subdivided};

Corners3 some_triangle(Noise& noise, double lo, double hi, double size)
{
    const glm::dvec3 center(noise.between(lo, hi), noise.between(lo, hi), noise.between(lo, hi));
    return {center + size * noise.vec3(), center + size * noise.vec3(),
            center + size * noise.vec3()};
}

double middle_of(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

TEST(ErrorBounds, AreNeverBelowTheSampledTruth)
{
    Noise noise(3);
    for (int order = 2; order <= max_order; ++order) {
        const Trivariate<glm::dvec3> f = random_volume(
            {Knots::uniform(order, order + 3), uneven_knots(order), Knots::periodic(5, 8)},
            static_cast<unsigned>(order));
        ErrorBounds bounds = bounds_of(f);
        for (int n = 0; n < 60; ++n) {
            // Some of them reach out of the domain, and round the closed axis.
            const Corners3 t = some_triangle(noise, -0.1, 1.1, n % 3 == 0 ? 0.3 : 0.06);
            const double truth = sampled_error(f, t);
            for (const BoundMethod method : true_methods)
                ASSERT_GE(bounds.triangle(corners_of(bounds, t), method), truth)
                    << "order " << order << " method " << static_cast<int>(method) << " no " << n;
        }
    }
}

TEST(ErrorBounds, HoldRoundATwistedBandAndForMixedOrders)
{
    Noise noise(5);
    const Trivariate<glm::dvec3> f = random_volume(
        {Knots::periodic(4, 9, 0, 1, Closure::twisted), Knots::uniform(3, 5), Knots::uniform(2, 2)},
        8);
    ErrorBounds bounds = bounds_of(f);
    for (int n = 0; n < 300; ++n) {
        const Corners3 t = some_triangle(noise, -2, 3, 0.2);
        const double truth = sampled_error(f, t);
        for (const BoundMethod method : {net_affine, composed_net, composed_net_subdivided})
            ASSERT_GE(bounds.triangle(corners_of(bounds, t), method), truth) << n;
    }
}

TEST(ErrorBounds, OfTheComposedNetAreTight)
{
    Noise noise(7);
    for (const int order : {3, 4}) {
        const Knots knots = Knots::uniform(order, 8);
        const Trivariate<glm::dvec3> f = random_volume({knots, knots, knots}, 2);
        ErrorBounds bounds = bounds_of(f);
        std::vector<double> net, subdivided;
        for (int n = 0; n < 400; ++n) {
            const Corners3 t = some_triangle(noise, 0.1, 0.9, n % 2 == 0 ? 0.03 : 0.1);
            const double truth = sampled_error(f, t, 24);
            net.push_back(bounds.triangle(corners_of(bounds, t), composed_net) / truth);
            subdivided.push_back(bounds.triangle(corners_of(bounds, t), composed_net_subdivided) /
                                 truth);
        }
        EXPECT_LT(middle_of(net), order == 3 ? 1.2 : 1.125);
        EXPECT_LT(middle_of(subdivided), 1.03);
    }
}

TEST(ErrorBounds, OfAProductAreItsErrorItself)
{
    const Trivariate<glm::dvec3> f =
        multilinear(0, 1, [](double x, double y, double) { return x * y; });
    ErrorBounds bounds = bounds_of(f);
    const auto corners = corners_of(bounds, {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 0}});
    EXPECT_NEAR(bounds.triangle(corners, thesis_right_angled), 0.25, 1e-9);
    EXPECT_NEAR(bounds.triangle(corners, best_corner), 0.25, 1e-9);
    EXPECT_NEAR(bounds.triangle(corners, composed_net_subdivided), 0.25, 0.02);
    EXPECT_NEAR(bounds.triangle(corners, thesis), 1, 1e-9) << "four times as much";
    EXPECT_NEAR(bounds.edge({corners[0], corners[1]}, best_corner), 0.25, 1e-9);
    EXPECT_LT(bounds.edge({corners[1], corners[2]}, composed_net), 1e-11);
}

TEST(ErrorBounds, OfAnAffineMapAreRounding)
{
    Trivariate<glm::dvec3> f =
        random_volume({Knots::uniform(4, 7), uneven_knots(3), Knots::uniform(5, 6, -1, 1)});
    for (int i = 0; i < f.axes[0].count(); ++i)
        for (int j = 0; j < f.axes[1].count(); ++j)
            for (int k = 0; k < f.axes[2].count(); ++k)
                f.points[f.index(i, j, k)] = {2 * f.axes[0].greville(i) - f.axes[2].greville(k),
                                              f.axes[1].greville(j), 3};
    ErrorBounds bounds = bounds_of(f);
    const auto corners = corners_of(bounds, {glm::dvec3(0.1), {0.9, 0.2, -0.5}, {0.5, 0.9, 0.8}});
    for (const BoundMethod method : {net_affine, composed_net, composed_net_subdivided})
        EXPECT_LT(bounds.triangle(corners, method), 1e-10);
}

// Erratum E-17: the mixed derivative counts twice.
TEST(ErrorBounds, OfTheThesisByTheCircumradiusAreFalse)
{
    const Trivariate<glm::dvec3> f =
        multilinear(-2, 2, [](double x, double y, double) { return x * y; });
    ErrorBounds bounds = bounds_of(f);
    Corners3 t; // equilateral, radius 1, with an edge at 45 degrees
    for (int i = 0; i < 3; ++i) {
        const double angle = glm::radians(-45.0 + 120 * i);
        t[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle), 0};
    }
    const double truth = sampled_error(f, t, 64);
    EXPECT_NEAR(truth, 0.375, 1e-3);
    const auto corners = corners_of(bounds, t);
    EXPECT_NEAR(bounds.triangle(corners, thesis_circumradius), 0.25, 1e-9);
    EXPECT_GE(bounds.triangle(corners, circumradius), truth);
    EXPECT_GE(bounds.triangle(corners, composed_net), truth);
    EXPECT_GE(bounds.triangle(corners, waldron), truth);
}

// Erratum E-18: a triangle with a small height has a circle as large as one likes.
TEST(ErrorBounds, ByTheCircumradiusMeanNothingForSlivers)
{
    const Knots knots = Knots::uniform(4, 6);
    const Trivariate<glm::dvec3> f = random_volume({knots, knots, knots});
    ErrorBounds bounds = bounds_of(f);
    const Corners3 t{glm::dvec3(0.4, 0.4, 0.4), {0.6, 0.4, 0.4}, {0.5, 0.4001, 0.4}};
    const double truth = sampled_error(f, t, 64);
    const auto corners = corners_of(bounds, t);
    EXPECT_GT(bounds.triangle(corners, thesis_circumradius), 1e3 * truth);
    EXPECT_GT(bounds.triangle(corners, circumradius), 1e3 * truth);
    EXPECT_LT(bounds.triangle(corners, waldron), 10 * truth);
    EXPECT_LT(bounds.triangle(corners, composed_net), 1.2 * truth);
}

// Erratum E-20: an error along a normal that moves is not bounded by F'' along it.
TEST(ErrorBounds, OfTheThesisAlongMovingNormalsAreFalse)
{
    const std::array<glm::dvec2, 4> p{
        glm::dvec2(-0.95, 0.53), {3.15, 0.33}, {1.53, 0.28}, {2.38, 0.47}};
    double error = 0, second = 0;
    for (int i = 0; i <= 800; ++i) {
        const double t = i / 800.0, s = 1 - t;
        const glm::dvec2 at =
            s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
        const glm::dvec2 first =
            3.0 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
        const glm::dvec2 by_tt =
            6.0 * (s * (p[2] - 2.0 * p[1] + p[0]) + t * (p[3] - 2.0 * p[2] + p[1]));
        const glm::dvec2 normal = glm::normalize(glm::dvec2(-first.y, first.x));
        error = std::max(error, std::abs(glm::dot(at - (s * p[0] + t * p[3]), normal)));
        second = std::max(second, std::abs(glm::dot(by_tt, normal)));
    }
    EXPECT_GT(error, 1.5 * second / 8);
}

// Erratum E-21: the bound falls by four when a triangle is cut in four; the error need not fall.
TEST(ErrorBounds, FallByFourWhereTheErrorItselfMayGrow)
{
    Noise noise(2);
    const Knots along = Knots::uniform(5, 5), flat = Knots::uniform(2, 2);
    double grown = 0;
    for (unsigned seed = 1; seed < 400; ++seed) {
        const Trivariate<glm::dvec3> f = random_volume({along, flat, flat}, seed);
        ErrorBounds bounds = bounds_of(f);
        const auto error = [&](double from, double to) {
            return sampled_error(f, {glm::dvec3(from, 0, 0), {to, 0, 0}, {to, 0, 0}}, 24);
        };
        const auto bound = [&](double from, double to) {
            return bounds.edge({bounds.corner({from, 0, 0}), bounds.corner({to, 0, 0})},
                               barycentric);
        };
        grown = std::max({grown, error(0, 0.5) / error(0, 1), error(0.5, 1) / error(0, 1)});
        ASSERT_LE(std::max(bound(0, 0.5), bound(0.5, 1)), bound(0, 1) / 4 * (1 + 1e-9));
    }
    EXPECT_GT(grown, 1);
}

TEST(ErrorBounds, SayNothingWhereTheirPremisesFail)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Corners3 t{glm::dvec3(0.3, 0.3, 0.3), {0.7, 0.3, 0.3}, {0.5, 0.4, 0.3}};
    // Order 2: the map has a kink at 0.5.
    const Knots kinked = Knots::uniform(2, 3), smooth = Knots::uniform(3, 4);
    ErrorBounds with_kink = bounds_of(random_volume({kinked, smooth, smooth}));
    EXPECT_EQ(with_kink.triangle(corners_of(with_kink, t), barycentric), infinity);
    EXPECT_LT(with_kink.triangle(corners_of(with_kink, t), composed_net), infinity);
    // A knot of full multiplicity: it jumps.
    const Knots torn = Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1});
    ErrorBounds with_jump = bounds_of(random_volume({torn, smooth, smooth}));
    for (const BoundMethod method : {barycentric, net_affine, composed_net})
        EXPECT_EQ(with_jump.triangle(corners_of(with_jump, t), method), infinity);
    // No right angle.
    ErrorBounds plain = bounds_of(random_volume({smooth, smooth, smooth}));
    EXPECT_EQ(plain.triangle(corners_of(plain, t), thesis_right_angled), infinity);
}

TEST(ErrorBounds, OfDegenerateTrianglesAreThoseOfTheirEdges)
{
    const Knots knots = Knots::uniform(4, 6);
    const Trivariate<glm::dvec3> f = random_volume({knots, knots, knots});
    ErrorBounds bounds = bounds_of(f);
    const Corners3 line{glm::dvec3(0.1), glm::dvec3(0.5), glm::dvec3(0.3)}, point{};
    for (const BoundMethod method : {barycentric, waldron, composed_net})
        EXPECT_GE(bounds.triangle(corners_of(bounds, line), method), sampled_error(f, line));
    EXPECT_LT(bounds.triangle(corners_of(bounds, point), composed_net), 1e-10);
}

} // namespace
} // namespace trivar
