// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/narrowing.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

TEST(Narrowings, AreOneWhereNothingWasNarrowed)
{
    Narrowing all;
    EXPECT_EQ(all.least(), 1);
    all.narrow(0.2, 0.5, 0.1);
    EXPECT_EQ(all.at(0.35), 1);
    EXPECT_NEAR(all.at(0.2), 0.5, 1e-12);
    EXPECT_EQ(all.least(), 0.5);
    for (int i = 0; i < 100; ++i)
        EXPECT_LE(std::abs(all.at(0.01 * i) - all.at(0.01 * i + 0.01)), 0.1); // no step
}

TEST(Narrowings, KeepTheWidestOpeningWhereTheyAreBesideIt)
{
    const IncisionProfile lens;
    Narrowing end, middle;
    end.narrow(0.1, 0, 0.2);
    middle.narrow(0.5, 0.25, 0.5);
    EXPECT_EQ(end.widest(lens), 1);
    EXPECT_LT(middle.widest(lens), 0.7);
    EXPECT_GT(middle.widest(lens), 0.25);
}

TEST(Narrowings, DrawTogetherBelowWithoutTheSkin)
{
    Admitted admitted;
    admitted.below.narrow(0.5, 0, 0.2);
    EXPECT_EQ(admitted.at(0.5, 0), 1);
    EXPECT_NEAR(admitted.at(0.5, 0.25), 0.5, 1e-12);
    EXPECT_EQ(admitted.at(0.5, 1), 0);
}

} // namespace
} // namespace trivar::testing
