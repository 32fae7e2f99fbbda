// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/ffd/deform_findings.h"
#include "tests/gpu/support.h"

#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

class DeformRates : public WithContext {};

TEST_F(DeformRates, AreMeasuredInEveryWayAndComparedWithTheProcessor)
{
    const DeformReport report = deform_rates({{Way::processor, {}, 3, 4, 500},
                                              {Way::one_phase, {}, 3, 4, 500},
                                              {Way::two_phases, {}, 3, 4, 500},
                                              {Way::two_phases, {}, 3, 4, 500, 2}},
                                             {.run_s = 10});
    ASSERT_EQ(report.rates.size(), 4u);
    EXPECT_GT(report.device.copy_bytes_per_s, 0);
    for (const DeformRate& rate : report.rates) {
        EXPECT_NEAR(rate.vertices_per_s * rate.time_ms, 500e3, 1);
        const bool device = rate.what.way != Way::processor;
        EXPECT_EQ(rate.arithmetic_allows_per_s > 0, device);
        EXPECT_EQ(rate.position_error.has_value(), device && rate.what.passes == 0);
        if (!rate.position_error) continue;
        EXPECT_LT(*rate.position_error, 1e-6);
        EXPECT_LT(rate.normal_error_deg.value(), 0.05);
    }
}

TEST_F(DeformRates, LeaveOutWhatTakesTooLongOrCannotBeDone)
{
    const DeformReport report = deform_rates({{Way::processor, {}, 3, 4, 100},
                                              {Way::processor, {}, 3, 4, 1'000'000'000},
                                              {Way::two_phases, {}, 5, 6, 100}},
                                             {.run_s = 0.01});
    EXPECT_EQ(report.rates.size(), 1u);
    EXPECT_THAT(report.notices, ::testing::ElementsAre(::testing::HasSubstr("order 5"),
                                                       ::testing::HasSubstr("1 of the cases")));
}

TEST_F(DeformRates, EndWhenTheirTimeIsOver)
{
    const DeformReport report = deform_rates(every_deform_case(), {.all_s = 0});
    EXPECT_GT(report.device.multiply_adds_per_s, 0);
    EXPECT_EQ(report.rates.size(), 0u);
    EXPECT_THAT(report.notices, ::testing::ElementsAre(::testing::HasSubstr("minutes were over")));
}

DeformCase exact_case(Way way, int passes)
{
    return {way, {}, 3, 8, 100'000, passes};
}

TEST(DeformCases, CountTheMultiplyAddsOfTheBook)
{
    const Method plain{Sum::nested, NormalsBy::nothing};
    EXPECT_EQ(multiply_adds({Way::two_phases, plain, 3}), 117);
    EXPECT_EQ(multiply_adds({Way::two_phases, plain, 4}), 252);
    EXPECT_EQ(multiply_adds({Way::two_phases, {}, 4}), 576 + 75);
}

// A pass more has one phase evaluate positions again and two phases read them.
TEST(DeformCases, CountWhatAPassCosts)
{
    const auto bytes = [](Way way, int passes) { return bytes_a_vertex(exact_case(way, passes)); };
    EXPECT_EQ(bytes(Way::one_phase, 1), 24);
    EXPECT_EQ(bytes(Way::one_phase, 3), 24 + 2 * 12);
    EXPECT_EQ(bytes(Way::two_phases, 0), 48);
    EXPECT_EQ(bytes(Way::two_phases, 2), 48 + 24 + 12);
    const double once = multiply_adds(exact_case(Way::two_phases, 0));
    EXPECT_EQ(multiply_adds(exact_case(Way::two_phases, 3)), once);
    EXPECT_EQ(multiply_adds(exact_case(Way::one_phase, 1)), once);
    EXPECT_EQ(multiply_adds(exact_case(Way::one_phase, 3)), once + 2 * 117);
}

TEST(DeformFindings, SayWhichWayCostsLessAndWhichBoundHolds)
{
    DeformReport report;
    for (int passes = 1; passes <= 3; ++passes) {
        report.rates.push_back({exact_case(Way::one_phase, passes), 2.0 * passes});
        report.rates.push_back({exact_case(Way::two_phases, passes), 2.5 + 0.5 * passes});
    }
    report.rates.push_back({exact_case(Way::two_phases, 0), 2.5, 4e7, 1e9, 5e7});
    EXPECT_THAT(findings(report),
                ::testing::ElementsAre(::testing::HasSubstr("80 % of what arithmetic allows"),
                                       ::testing::HasSubstr("less from the second on")));
}

} // namespace
} // namespace trivar::gpu::testing
