// SPDX-License-Identifier: GPL-3.0-or-later
// The Bezier form, another view of the same function, and what shapes a spline may have.
#include "core/base/rejected.h"
#include "core/spline/bezier.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::all_axes;
using testing::Noise;
using testing::random_curve;
using testing::random_surface;
using testing::random_volume;

glm::dvec3 by_de_casteljau(std::vector<glm::dvec3> p, double x)
{
    for (std::size_t n = p.size(); n > 1; --n)
        for (std::size_t i = 0; i + 1 < n; ++i) p[i] = glm::mix(p[i], p[i + 1], x);
    return p[0];
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
                const std::vector<glm::dvec3> p(form.points.begin() + cell.first,
                                                form.points.begin() + cell.first + knots.order());
                const double t = cell.lo + x * (cell.hi - cell.lo);
                EXPECT_LT(glm::distance(by_de_casteljau(p, x), evaluate(c, t).value), 1e-14);
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
    for (int order = 2; order <= max_order; ++order) {
        const auto c = random_curve(Knots::uniform(order, order));
        const auto m = bezier_segment(order, 0.3, 0.45);
        for (const double x : {0.0, 0.25, 0.5, 1.0}) {
            std::vector<glm::dvec3> p(static_cast<std::size_t>(order), glm::dvec3(0));
            for (std::size_t i = 0; i < p.size(); ++i)
                for (std::size_t k = 0; k < p.size(); ++k)
                    p[i] += m[i * p.size() + k] * c.points[k];
            EXPECT_LT(glm::distance(by_de_casteljau(p, x), evaluate(c, 0.3 + 0.15 * x).value),
                      1e-14);
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
