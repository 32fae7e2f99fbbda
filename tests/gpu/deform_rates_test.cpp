// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_rates.h"
#include "tests/gpu/support.h"

#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

class DeformRates : public WithContext {};

TEST_F(DeformRates, AreMeasuredInEveryWayAndComparedWithTheProcessor)
{
    const DeformReport report = deform_rates({{Way::processor, {}, 3, 4, 500},
                                              {Way::one_phase, {}, 3, 4, 500},
                                              {Way::two_phases, {}, 3, 4, 500}},
                                             10);
    ASSERT_EQ(report.rates.size(), 3u);
    EXPECT_GT(report.device.copy_bytes_per_s, 0);
    for (const DeformRate& rate : report.rates) {
        EXPECT_NEAR(rate.vertices_per_s * rate.time_ms, 500e3, 1);
        EXPECT_EQ(rate.arithmetic_allows_per_s > 0, rate.what.way != Way::processor);
    }
    EXPECT_LT(report.rates.back().position_error.value(), 1e-6);
    EXPECT_LT(report.rates.back().normal_error_deg.value(), 0.05);
}

TEST_F(DeformRates, LeaveOutWhatTakesTooLongOrCannotBeDone)
{
    const DeformReport report = deform_rates({{Way::processor, {}, 3, 4, 100},
                                              {Way::processor, {}, 3, 4, 1'000'000'000},
                                              {Way::two_phases, {}, 5, 6, 100}},
                                             0.01);
    EXPECT_EQ(report.rates.size(), 1u);
    EXPECT_THAT(report.notices, ::testing::ElementsAre(::testing::HasSubstr("order 5"),
                                                       ::testing::HasSubstr("1 of the cases")));
}

TEST(DeformCases, CountTheMultiplyAddsOfTheBook)
{
    const Method plain{Sum::nested, NormalsBy::nothing};
    EXPECT_EQ(multiply_adds(3, plain), 117);
    EXPECT_EQ(multiply_adds(4, plain), 252);
    EXPECT_EQ(multiply_adds(4, {}), 576 + 75);
}

} // namespace
} // namespace trivar::gpu::testing
