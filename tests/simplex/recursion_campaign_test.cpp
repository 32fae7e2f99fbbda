// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simplex/recursion_campaign.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// The small version of manual_simplex_campaign.
TEST(RecursionCampaign, FindsValuesAndSumsRightInDegenerateDomains)
{
    for (const CampaignClass& each : recursion_campaign(600, 1)) {
        EXPECT_GE(each.points, 100U);
        EXPECT_LE(each.worst_value, 1e-10) << each.variables << each.degree << each.worst_value_at;
        EXPECT_LE(each.worst_sum, 1e-12) << each.variables << each.degree << each.worst_sum_at;
    }
}

} // namespace
} // namespace trivar
