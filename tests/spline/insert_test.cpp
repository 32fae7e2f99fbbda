// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/insert.h"

#include "core/base/rejected.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::all_axes;
using testing::insert_knot;
using testing::inside;
using testing::Noise;
using testing::random_curve;
using testing::random_surface;
using testing::random_volume;

// Largest distance over the common domain, the derivatives' included where asked.
double largest_change(const Curve<glm::dvec3>& a, const Curve<glm::dvec3>& b)
{
    double largest = 0;
    for (const double t : inside(b.knots, 173))
        largest = std::max(largest, glm::distance(evaluate(a, t).value, evaluate(b, t).value));
    return largest;
}

TEST(KnotInsertion, LeavesTheCurveWhereItWas)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const double span = knots.end() - knots.begin();
        auto finer = c;
        for (const double share : {0.31, 0.4, 0.77, 0.02, 0.31}) {
            if (knots.order() == 2 && finer.knots.multiplicity(knots.begin() + share * span) > 1)
                continue;
            finer = insert_knot(finer, knots.begin() + share * span);
            EXPECT_LT(largest_change(c, finer), 1e-14) << knots.order();
        }
        EXPECT_GT(finer.knots.count(), knots.count() + 3);
    }
}

TEST(KnotInsertion, OfManyIsTheSameAsOneByOne)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const double a = knots.begin() + 0.11 * (knots.end() - knots.begin());
        const double b = knots.begin() + 0.63 * (knots.end() - knots.begin());
        const std::vector<double> both{b, a};
        const auto at_once = insert_knots(c, 0, both);
        const auto one_by_one = insert_knot(insert_knot(c, a), b);
        ASSERT_EQ(at_once.knots, one_by_one.knots);
        for (std::size_t i = 0; i < at_once.points.size(); ++i)
            EXPECT_LT(glm::distance(at_once.points[i], one_by_one.points[i]), 1e-14);
    }
}

// Boehm's formula, for a knot in the interior of a clamped axis.
TEST(KnotInsertion, GivesBoehmsPoints)
{
    const Knots knots = testing::uneven_knots(4);
    const auto c = random_curve(knots);
    const double t = 0.5;
    const int s = knots.span(t), o = 4;
    const auto finer = insert_knot(c, t);
    for (int i = 0; i < finer.knots.count(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto& k = knots.values();
        const double a = i <= s - o + 1 ? 1 : i > s ? 0 : (t - k[at]) / (k[at + 3] - k[at]);
        const glm::dvec3 before = i > 0 ? c.points[at - 1] : glm::dvec3(0);
        const glm::dvec3 here = at < c.points.size() ? c.points[at] : glm::dvec3(0);
        EXPECT_LT(glm::distance(finer.points[at], (1 - a) * before + a * here), 1e-15);
    }
}

TEST(KnotInsertion, WorksAlongEveryAxisOfAVolume)
{
    Noise noise;
    const std::array<Knots, 3> axes{Knots::uniform(3, 4), testing::uneven_knots(4),
                                    Knots::periodic(2, 5)};
    const auto f = random_volume(axes);
    auto finer = f;
    const std::vector<double> knots{0.2, 0.37, 0.85};
    for (int axis = 0; axis < 3; ++axis) finer = insert_knots(finer, axis, knots);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
        EXPECT_LT(glm::distance(evaluate(f, p).value, evaluate(finer, p).value), 2e-15);
    }
}

TEST(KnotInsertion, WorksAlongAndAcrossAMoebiusBand)
{
    Noise noise;
    const auto f =
        random_surface({Knots::periodic(3, 6, 0, 1, Closure::twisted), Knots::uniform(3, 4)});
    const std::vector<double> once{0.2, 0.9}, across{0.25, 0.75};
    const auto finer = insert_knots(insert_knots(f, 0, once), 1, across);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 p = 2.0 * noise.vec2() * glm::dvec2(1, 0.25) + glm::dvec2(0, 0.5);
        EXPECT_LT(glm::distance(evaluate(f, p).value, evaluate(finer, p).value), 1e-14);
    }
}

TEST(KnotInsertion, RefusesKnotsOutsideAndMultiplicityAboveTheOrder)
{
    const auto c = random_curve(Knots::uniform(3, 5));
    EXPECT_THROW(insert_knot(c, -0.1), Rejected);
    EXPECT_THROW(insert_knot(c, std::nan("")), Rejected);
    EXPECT_THROW(insert_knot(c, 0), Rejected);
    auto torn = c;
    for (int i = 0; i < 3; ++i) torn = insert_knot(torn, 0.4);
    EXPECT_THROW(insert_knot(torn, 0.4), Rejected);
}

// Two points may be moved apart only where a knot is repeated `order` times: with one less the
// pieces still share a control point.
TEST(KnotInsertion, TearsOnlyAtFullMultiplicity)
{
    for (int order = 2; order <= max_order; ++order) {
        auto c = random_curve(Knots::uniform(order, order + 3));
        const auto gap = [&](const Curve<glm::dvec3>& curve) {
            return glm::distance(evaluate(curve, std::nextafter(0.4, 0)).value,
                                 evaluate(curve, 0.4).value);
        };
        for (int i = 0; i < order - 1; ++i) c = insert_knot(c, 0.4);
        auto moved = c;
        const int s = c.knots.span(0.4);
        moved.points[static_cast<std::size_t>(s - order + 1)] += glm::dvec3(1, 0, 0);
        EXPECT_LT(gap(moved), 1e-13) << "only C^0 at order " << order;
        c = insert_knot(c, 0.4);
        EXPECT_LT(gap(c), 1e-13);
        const int after = c.knots.span(0.4) - order + 1;
        c.points[static_cast<std::size_t>(after)] += glm::dvec3(1, 0, 0);
        EXPECT_NEAR(gap(c), 1, 1e-12) << "a jump at order " << order;
    }
}

TEST(Opening, TurnsAClosedAxisIntoAClampedOneOfTheSameShape)
{
    for (int order = 2; order <= max_order; ++order) {
        const auto c = random_curve(Knots::periodic(order, order + 2, 0, 3));
        const auto open = over_knots(c, 0, opened(c.knots));
        EXPECT_EQ(open.knots.closure(), Closure::open);
        EXPECT_LT(largest_change(c, open), 1e-14);
        EXPECT_LT(glm::distance(open.points.front(), open.points.back()), 1e-15);
    }
}

} // namespace
} // namespace trivar
