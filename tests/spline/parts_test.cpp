// SPDX-License-Identifier: GPL-3.0-or-later
// Sub-boxes, Bezier cells, iso-surfaces and derivatives: other views of the same function.
#include "core/base/rejected.h"
#include "core/spline/bezier.h"
#include "core/spline/derivative.h"
#include "core/spline/iso.h"
#include "core/spline/restrict.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::all_axes;
using testing::inside;
using testing::Noise;
using testing::random_curve;
using testing::random_surface;
using testing::random_volume;

TEST(Restriction, KeepsTheCurveOverItsPart)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const double length = knots.end() - knots.begin();
        for (const double lo : {0.0, 0.13, 0.4})
            for (const double hi : {0.41, 0.9, 1.0}) {
                const double a = knots.begin() + lo * length;
                const double b = hi == 1 ? knots.end() : knots.begin() + hi * length;
                const auto part = restricted(c, 0, a, b);
                EXPECT_EQ(part.knots.begin(), a);
                EXPECT_EQ(part.knots.end(), b);
                for (const double t : inside(part.knots, 50))
                    EXPECT_LT(glm::distance(evaluate(part, t).value,
                                            evaluate(c, std::min(t, b * (1 - 1e-16))).value),
                              2e-14);
            }
    }
}

TEST(Restriction, TakesTheSideItLiesOnAtATear)
{
    const Curve<double> torn{Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}),
                             {0, 1, 2, 10, 11, 12}};
    EXPECT_EQ(restricted(torn, 0, 0.1, 0.5).points.back(), 2);
    EXPECT_EQ(restricted(torn, 0, 0.5, 0.8).points.front(), 10);
    const auto across = restricted(torn, 0, 0.25, 0.75);
    EXPECT_DOUBLE_EQ(evaluate(across, std::nextafter(0.5, 0)).value, 2);
    EXPECT_DOUBLE_EQ(evaluate(across, 0.5).value, 10);
}

TEST(Restriction, OfAVolumeToABoxKeepsItsPoints)
{
    const auto f =
        random_volume({Knots::uniform(3, 5), testing::uneven_knots(4), Knots::periodic(3, 5)});
    const glm::dvec3 lo(0.2, 0.1, 0.3), hi(0.7, 0.85, 0.9);
    const auto part = restricted(f, lo, hi);
    Noise noise;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = lo + (hi - lo) * (noise.vec3() * 0.5 + 0.5);
        EXPECT_LT(glm::distance(evaluate(f, p).value, evaluate(part, p).value), 1e-14);
    }
}

TEST(Restriction, RefusesPartsThatAreNotInside)
{
    const auto c = random_curve(Knots::uniform(3, 5));
    EXPECT_THROW(restricted(c, 0, -0.1, 0.5), Rejected);
    EXPECT_THROW(restricted(c, 0, 0.5, 0.5), Rejected);
    EXPECT_THROW(restricted(c, 0, 0.5, std::nan("")), Rejected);
}

TEST(BezierForm, IsTheSameShapeInCellsOfBernsteinPolynomials)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const auto form = bezier_form(c);
        for (const BezierSpan& cell : bezier_spans(form.knots)) {
            EXPECT_LT(glm::distance(form.points[static_cast<std::size_t>(cell.first)],
                                    evaluate(c, cell.lo).value),
                      1e-14)
                << "a cell starts at its first point";
            for (const double x : {0.0, 0.25, 0.5, 0.9}) {
                // de Casteljau.
                std::vector<glm::dvec3> p(form.points.begin() + cell.first,
                                          form.points.begin() + cell.first + knots.order());
                for (std::size_t n = p.size(); n > 1; --n)
                    for (std::size_t i = 0; i + 1 < n; ++i) p[i] = glm::mix(p[i], p[i + 1], x);
                const double t = cell.lo + x * (cell.hi - cell.lo);
                EXPECT_LT(glm::distance(p[0], evaluate(c, t).value), 1e-14);
            }
        }
    }
}

TEST(BezierForm, OfATornAxisKeepsTheTear)
{
    const Knots torn = Knots::general(3, {0, 0, 0, 0.3, 0.5, 0.5, 0.5, 1, 1, 1});
    const auto form = bezier_form(random_curve(torn));
    EXPECT_EQ(form.knots.multiplicity(0.5), 3);
    EXPECT_EQ(form.knots.multiplicity(0.3), 2);
    EXPECT_EQ(bezier_spans(form.knots).back().first, form.knots.count() - 3);
}

TEST(BezierForm, OfAMoebiusVolumeOpensIt)
{
    const auto f = random_volume({Knots::periodic(3, 5, 0, 1, Closure::twisted),
                                  Knots::uniform(3, 4), Knots::uniform(2, 3)});
    const auto form = bezier_form(f);
    Noise noise;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
        EXPECT_LT(glm::distance(evaluate(f, p).value, evaluate(form, p).value), 1e-14);
    }
}

TEST(BezierSegment, IsTheBezierFormOfThePart)
{
    Noise noise;
    for (int order = 2; order <= max_order; ++order) {
        const auto c = random_curve(Knots::uniform(order, order));
        const auto part = restricted(c, 0, 0.3, 0.45);
        const auto m = bezier_segment(order, 0.3, 0.45);
        for (int i = 0; i < order; ++i) {
            glm::dvec3 p(0);
            for (int k = 0; k < order; ++k)
                p += m[static_cast<std::size_t>(i * order + k)] *
                     c.points[static_cast<std::size_t>(k)];
            EXPECT_LT(glm::distance(p, part.points[static_cast<std::size_t>(i)]), 1e-14);
        }
    }
}

TEST(IsoSurface, IsTheVolumeWithOneParameterFixed)
{
    const auto f =
        random_volume({Knots::uniform(3, 5), Knots::periodic(4, 6), testing::uneven_knots(2)});
    Noise noise;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
        const glm::dvec3 truth = evaluate(f, p).value;
        EXPECT_LT(glm::distance(evaluate(iso_surface(f, 0, p.x), {p.y, p.z}).value, truth), 1e-14);
        EXPECT_LT(glm::distance(evaluate(iso_surface(f, 1, p.y), {p.x, p.z}).value, truth), 1e-14);
        const auto s = iso_surface(f, 2, p.z);
        EXPECT_LT(glm::distance(evaluate(s, {p.x, p.y}).value, truth), 1e-14);
        EXPECT_LT(glm::distance(evaluate(iso_curve(s, 0, p.x), p.y).value, truth), 1e-14);
        EXPECT_LT(glm::distance(evaluate(iso_curve(s, 1, p.y), p.x).value, truth), 1e-14);
    }
}

TEST(IsoSurface, OfAClampedFaceIsTheOuterLayerOfPoints)
{
    const auto f =
        random_volume({Knots::uniform(3, 5), Knots::uniform(4, 6), Knots::uniform(2, 3)});
    const auto bottom = iso_surface(f, 2, 0);
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 6; ++j) EXPECT_EQ(bottom.point(i, j), f.point(i, j, 0));
}

TEST(IsoSurface, OfATwistedVolumeFollowsOddTurns)
{
    const auto f = random_volume({Knots::periodic(3, 5, 0, 1, Closure::twisted),
                                  Knots::uniform(3, 4), Knots::uniform(2, 3)});
    Noise noise;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
        const glm::dvec3 round = p + glm::dvec3(1, 0, 0);
        EXPECT_LT(glm::distance(evaluate(iso_surface(f, 0, round.x), {p.y, p.z}).value,
                                evaluate(f, round).value),
                  1e-14);
        EXPECT_LT(
            glm::distance(evaluate(iso_surface(f, 2, p.z), {p.x, p.y}).value, evaluate(f, p).value),
            1e-14);
    }
}

TEST(DerivativeNet, IsTheDerivativeForEveryAxisAndOrder)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const auto d = derivative(c, 0);
        EXPECT_EQ(d.knots.closure(), knots.closure());
        EXPECT_EQ(d.knots.order(), std::max(2, knots.order() - 1));
        ASSERT_EQ(d.points.size(), static_cast<std::size_t>(d.knots.count()));
        EXPECT_EQ(d.knots.begin(), knots.begin());
        EXPECT_EQ(d.knots.end(), knots.end());
        const double length = knots.end() - knots.begin();
        for (int i = 0; i < 60; ++i) {
            const double t = knots.begin() + length * (i + 0.37) / 60;
            EXPECT_LT(glm::distance(evaluate(d, t).value, evaluate(c, t, 1).first), 1e-12);
        }
    }
}

TEST(DerivativeNet, BoundsTheDerivative)
{
    for (const Knots& knots : all_axes()) {
        Noise noise;
        Curve<double> c{knots, {}};
        for (int i = 0; i < knots.count(); ++i) c.points.push_back(noise());
        const auto d = derivative(c, 0);
        const auto [low, high] = std::minmax_element(d.points.begin(), d.points.end());
        for (const double t : inside(knots, 200)) {
            EXPECT_LE(evaluate(c, t, 1).first, *high + 1e-12);
            EXPECT_GE(evaluate(c, t, 1).first, *low - 1e-12);
        }
    }
}

TEST(DerivativeNet, DropsPointsThatATearLeavesWithoutASpan)
{
    const auto c = random_curve(Knots::general(3, {0, 0, 0, 0.3, 0.5, 0.5, 0.5, 1, 1, 1}));
    const auto d = derivative(c, 0);
    EXPECT_EQ(d.knots.count(), c.knots.count() - 2);
    for (const double t : {0.0, 0.2, 0.4, 0.5, 0.7, 1.0})
        EXPECT_LT(glm::distance(evaluate(d, t).value, evaluate(c, t, 1).first), 1e-12);
}

TEST(DerivativeNet, WorksAlongEveryAxisOfAMoebiusVolume)
{
    const auto f = random_volume({Knots::periodic(3, 5, 0, 1, Closure::twisted),
                                  Knots::uniform(3, 4), Knots::uniform(2, 3)});
    Noise noise;
    for (int axis = 0; axis < 3; ++axis) {
        const auto d = derivative(f, axis);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
            EXPECT_LT(glm::distance(evaluate(d, p).value,
                                    evaluate(f, p, 1).first[static_cast<std::size_t>(axis)]),
                      1e-12);
        }
    }
}

TEST(Shape, OfTwistedAxesWantsSymmetricNeighbours)
{
    const Knots round = Knots::periodic(3, 5, 0, 1, Closure::twisted);
    EXPECT_NO_THROW(check_shape(random_surface({round, Knots::uniform(3, 6, -1, 2)})));
    EXPECT_THROW(check_shape(random_surface({round, testing::uneven_knots(3)})), Rejected);
    EXPECT_THROW(check_shape(random_surface({round, Knots::periodic(3, 5)})), Rejected);
    const auto band = random_surface({round, Knots::uniform(3, 6)});
    EXPECT_THROW(insert_knots(band, 1, std::vector<double>{0.1}), Rejected);
    auto short_of = band;
    short_of.points.pop_back();
    EXPECT_THROW(check_shape(short_of), Rejected);
}

} // namespace
} // namespace trivar
