// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/knots.h"

#include "core/base/rejected.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace trivar {
namespace {

using testing::all_axes;
using testing::inside;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Knots, RejectOrdersOutsideTwoToSix)
{
    for (const int order : {-1, 0, 1, 7, 1000000}) {
        EXPECT_THROW(Knots::uniform(order, 10), Rejected);
        EXPECT_THROW(Knots::periodic(order, 10), Rejected);
        EXPECT_THROW(Knots::general(order, std::vector<double>(20, 1.0)), Rejected);
    }
}

TEST(Knots, RejectTooFewAndAbsurdlyManyControlPoints)
{
    for (const int count : {-5, 0, 2, 2000000000}) {
        EXPECT_THROW(Knots::uniform(3, count), Rejected);
        EXPECT_THROW(Knots::periodic(3, count), Rejected);
    }
    EXPECT_THROW(Knots::general(3, {}), Rejected);
    EXPECT_THROW(Knots::closed(3, {}, 1), Rejected);
}

TEST(Knots, RejectSequencesThatDecreaseRepeatTooOftenOrAreNoNumbers)
{
    EXPECT_THROW(Knots::general(3, {0, 0, 0, 0.6, 0.5, 1, 1, 1}), Rejected);
    EXPECT_THROW(Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1}), Rejected);
    EXPECT_THROW(Knots::general(3, {0, 0, 0, not_a_number, 1, 1, 1}), Rejected);
    EXPECT_THROW(Knots::general(3, {0, 0, 0, 0.5, 1, 1, infinite}), Rejected);
    EXPECT_THROW(Knots::uniform(3, 5, 1, 1), Rejected);
    EXPECT_THROW(Knots::uniform(3, 5, 1, 0), Rejected);
    EXPECT_THROW(Knots::uniform(3, 5, not_a_number, 1), Rejected);
    EXPECT_THROW(Knots::periodic(3, 5, 0, infinite), Rejected);
    EXPECT_THROW(Knots::closed(3, {0, 0.5, 0.7}, 0.6), Rejected);
    EXPECT_THROW(Knots::closed(3, {0, 0.5, 0.5, 0.5, 0.5}, 1), Rejected);
    EXPECT_NO_THROW(Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}));
}

TEST(Knots, UniformOnesAreClampedAndEquallySpaced)
{
    const Knots k = Knots::uniform(3, 6, -1, 3);
    EXPECT_EQ(k.values(), (std::vector<double>{-1, -1, -1, 0, 1, 2, 3, 3, 3}));
    EXPECT_EQ(k.breaks(), (std::vector<double>{-1, 0, 1, 2, 3}));
    EXPECT_EQ(k.multiplicity(-1), 3);
    EXPECT_EQ(k.multiplicity(0.5), 0);
}

TEST(Knots, PeriodicOnesRepeatTheirSpacing)
{
    const Knots k = Knots::closed(3, {0, 0.25, 0.75}, 1);
    EXPECT_EQ(k.values(), (std::vector<double>{-0.75, -0.25, 0, 0.25, 0.75, 1, 1.25, 1.75}));
    EXPECT_EQ(k.begin(), 0);
    EXPECT_EQ(k.end(), 1);
    EXPECT_EQ(k.unwrapped_count(), 5);
    EXPECT_EQ(k.wrapped(4).index, 1);
}

TEST(Knots, SpanHoldsItsParameterAndHasALength)
{
    for (const Knots& k : all_axes())
        for (const double t : inside(k, 301)) {
            const auto s = static_cast<std::size_t>(k.span(t));
            EXPECT_LT(k.values()[s], k.values()[s + 1]);
            EXPECT_LE(k.values()[s], t);
            EXPECT_TRUE(t < k.values()[s + 1] || t == k.end());
        }
}

TEST(Knots, BringParametersIntoTheDomain)
{
    const Knots open = Knots::uniform(3, 5), round = Knots::periodic(3, 5, 1, 3),
                band = Knots::periodic(3, 5, 0, 1, Closure::twisted);
    EXPECT_EQ(open.into_domain(-2).t, 0);
    EXPECT_EQ(open.into_domain(infinite).t, 1);
    EXPECT_EQ(round.into_domain(3.5).t, 1.5);
    EXPECT_EQ(round.into_domain(0.5).t, 2.5);
    EXPECT_FALSE(round.into_domain(3.5).odd);
    EXPECT_TRUE(band.into_domain(1.25).odd);
    EXPECT_TRUE(band.into_domain(-0.25).odd);
    EXPECT_FALSE(band.into_domain(2.25).odd);
    EXPECT_FALSE(band.into_domain(-1.75).odd);
    for (const double far : {1e18, -1e300}) {
        const double t = band.into_domain(far).t;
        EXPECT_TRUE(t >= 0 && t <= 1);
    }
}

TEST(Knots, AParameterThatIsNoNumberStaysOneAndHarmsNothing)
{
    for (const Knots& k : all_axes()) {
        const double t = k.into_domain(not_a_number).t;
        EXPECT_TRUE(std::isnan(t));
        EXPECT_TRUE(std::isnan(basis(k, t, 2).value[0]));
    }
}

TEST(Basis, IsAPartitionOfUnityAndNeverNegative)
{
    for (const Knots& k : all_axes())
        for (const double t : inside(k, 257)) {
            const Basis b = basis(k, t, 2);
            const auto sum = [&](const auto& row) {
                return std::accumulate(row.begin(), row.begin() + k.order(), 0.0);
            };
            EXPECT_NEAR(sum(b.value), 1, 1e-14);
            // Sums of entries as large as degree / spacing and its square.
            EXPECT_NEAR(sum(b.first_derivative), 0, 1e-12);
            EXPECT_NEAR(sum(b.second_derivative), 0, 1e-10);
            for (const double n : b.value) EXPECT_GE(n, 0);
        }
}

TEST(Basis, HasLinearPrecisionAtTheGrevilleAbscissae)
{
    for (const Knots& k : all_axes())
        for (const double t : inside(k, 257)) {
            const Basis b = basis(k, t, 2);
            double value = 0, first = 0, second = 0;
            for (int i = 0; i < k.order(); ++i) {
                const double xi = k.greville(b.first + i);
                value += xi * b.value[static_cast<std::size_t>(i)];
                first += xi * b.first_derivative[static_cast<std::size_t>(i)];
                second += xi * b.second_derivative[static_cast<std::size_t>(i)];
            }
            EXPECT_NEAR(value, t, 1e-14 * 3);
            EXPECT_NEAR(first, 1, 1e-12);
            EXPECT_NEAR(second, 0, 1e-10);
        }
}

// Order 3, uniform knots: (1 - x)^2 / 2, 1/2 + x - x^2, x^2 / 2 (de Boor 1978, chapter X).
TEST(Basis, OfOrderThreeIsTheKnownPieces)
{
    const Knots k = Knots::periodic(3, 4, 0, 4);
    for (const double x : {0.0, 0.3, 0.8}) {
        const Basis b = basis(k, 1 + x, 2);
        EXPECT_NEAR(b.value[0], (1 - x) * (1 - x) / 2, 1e-15);
        EXPECT_NEAR(b.value[1], 0.5 + x - x * x, 1e-15);
        EXPECT_NEAR(b.value[2], x * x / 2, 1e-15);
        EXPECT_NEAR(b.first_derivative[1], 1 - 2 * x, 1e-15);
        EXPECT_NEAR(b.second_derivative[1], -2, 1e-14);
    }
}

TEST(Basis, AtTheEndsOfAClampedAxisIsTheEndPointAlone)
{
    for (int order = 2; order <= max_order; ++order) {
        const Knots k = Knots::uniform(order, order + 3, 0.1, 0.7);
        EXPECT_EQ(basis(k, k.begin()).value[0], 1);
        EXPECT_EQ(basis(k, k.end()).value[static_cast<std::size_t>(order - 1)], 1);
    }
}

} // namespace
} // namespace trivar
