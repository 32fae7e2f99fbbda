// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/field/blur.h"
#include "core/field/field_hulls.h"
#include "tests/field/fields.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

using Field = ScalarField<double>;

Field field_of(const SampledField& from, FieldOrder order = FieldOrder::cubic,
               FieldSpline spline = FieldSpline::interpolating)
{
    return {std::span<const double>(from.samples), from.size, spline, order};
}

SampledField uneven() // sizes that differ, with noise
{
    SampledField out = sampled("noise", 12);
    out.size = {12, 9, 16};
    return out;
}

constexpr std::array orders{FieldOrder::linear, FieldOrder::quadratic, FieldOrder::cubic};

TEST(ScalarField, GoesThroughItsSamples)
{
    const SampledField from = uneven();
    for (const FieldOrder order : orders) {
        const Field field = field_of(from, order);
        std::size_t n = 0;
        for (int k = 0; k < from.size.z; ++k)
            for (int j = 0; j < from.size.y; ++j)
                for (int i = 0; i < from.size.x; ++i)
                    ASSERT_NEAR(field.at<0>(i, j, k).value, from.samples[n++], 1e-12);
    }
}

TEST(ScalarField, OfSmoothedSamplesHasThemAsCoefficients)
{
    const SampledField from = uneven();
    const Field field = field_of(from, FieldOrder::cubic, FieldSpline::smoothing);
    EXPECT_EQ(field.coefficient(3, 4, 5), from.samples[3 + 12 * (4 + 9 * 5)]);
    EXPECT_EQ(field.coefficient(-1, 4, 5), field.coefficient(1, 4, 5));
    EXPECT_EQ(field.coefficient(3, 9, 5), field.coefficient(3, 7, 5));
    EXPECT_EQ(field.coefficient(3, 4, 16), field.coefficient(3, 4, 14));
}

TEST(ScalarField, HasTheDerivativesOfItsValues)
{
    const SampledField from = uneven();
    std::minstd_rand random(1);
    std::uniform_real_distribution<double> share(0.1, 0.9);
    for (const FieldOrder order : {FieldOrder::quadratic, FieldOrder::cubic}) {
        const Field field = field_of(from, order);
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 p(11 * share(random), 8 * share(random), 15 * share(random));
            const ScalarJet<double> jet = field.at<2>(p);
            constexpr double h = 1e-5;
            constexpr std::array<std::array<int, 3>, 3> number{{{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}};
            for (int a = 0; a < 3; ++a) {
                glm::dvec3 step(0);
                step[a] = h;
                const auto before = field.at<2>(p - step), after = field.at<2>(p + step);
                ASSERT_NEAR((after.value - before.value) / (2 * h),
                            jet.gradient[static_cast<std::size_t>(a)], 1e-5);
                const bool near_knot = // where the second derivatives of a quadratic jump
                    order == FieldOrder::quadratic && std::abs(p[a] - std::floor(p[a]) - 0.5) < h;
                for (std::size_t b = 0; b < 3 && !near_knot; ++b)
                    ASSERT_NEAR((after.gradient[b] - before.gradient[b]) / (2 * h),
                                jet.hessian[static_cast<std::size_t>(
                                    number[static_cast<std::size_t>(a)][b])],
                                1e-4);
            }
        }
    }
}

TEST(ScalarField, IsWithinItsHulls)
{
    const SampledField from = uneven();
    const std::vector<float> samples = in_single_precision(from.samples);
    const ScalarField<float> field{std::span<const float>(samples), from.size};
    const FieldHulls hulls(field);
    std::minstd_rand random(2);
    std::uniform_real_distribution<float> share(0, 1);
    for (int n = 0; n < 10000; ++n) {
        const glm::vec3 p = field.end() * glm::vec3(share(random), share(random), share(random));
        const FieldHulls::Range& range = hulls.of(hulls.brick_of(p));
        const float value = field.at<0>(p).value;
        ASSERT_GE(value, range.least - 1e-5f);
        ASSERT_LE(value, range.greatest + 1e-5f);
    }
}

TEST(ScalarField, IsTheSameForAnyNumberOfThreads)
{
    const SampledField from = sampled("gauss", 40);
    const Field many = field_of(from);
    const ThreadLimit one(1);
    const Field alone = field_of(from);
    for (int k = -1; k <= 40; ++k)
        for (int i = -1; i <= 40; ++i)
            ASSERT_EQ(many.coefficient(i, 7, k), alone.coefficient(i, 7, k));
}

// Means stay, constants too, and straight lines but for the ends.
TEST(Blur, KeepsWhatIsEven)
{
    const glm::ivec3 size(7, 5, 6);
    std::vector<float> samples;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) samples.push_back(static_cast<float>(i + 10 * k));
    const std::vector<float> out = blurred(std::span<const float>(samples), size, 2);
    const auto at = [&](const std::vector<float>& all, int i, int j, int k) {
        return all[static_cast<std::size_t>(i + 7 * (j + 5 * k))];
    };
    EXPECT_FLOAT_EQ(at(out, 3, 0, 3), at(samples, 3, 0, 3));
    EXPECT_GT(at(out, 0, 2, 3), at(samples, 0, 2, 3)); // the line turns back there
    const std::vector<float> even(samples.size(), 3);
    EXPECT_EQ(blurred(std::span<const float>(even), size, 4), even);
    EXPECT_EQ(blurred(std::span<const float>(samples), size, 0), samples);
}

TEST(ScalarField, RefusesSizesThatAreNotItsSamples)
{
    const std::vector<double> samples(12);
    const std::span<const double> all(samples);
    EXPECT_THROW(Field(all, {12, 1, 1}), Rejected);
    EXPECT_THROW(Field(all, {2, 2, 2}), Rejected);
    EXPECT_NO_THROW(Field(all, {3, 2, 2}));
}

} // namespace
} // namespace trivar::testing
