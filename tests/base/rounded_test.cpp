// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounded.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Rounded, IsWhatAPersonWouldType)
{
    EXPECT_EQ(rounded(0.4200001, 3), 0.42);
    EXPECT_EQ(rounded(-1234.5, 2), -1200);
    EXPECT_EQ(rounded(0, 3), 0);
}

TEST(Rounded, UpIsNeverBelow)
{
    EXPECT_EQ(rounded_up(0.0100449, 3), 0.0101);
    EXPECT_EQ(rounded_up(0.42, 3), 0.42);
    EXPECT_EQ(rounded_up(9.991, 3), 10);
    EXPECT_EQ(rounded_up(-1.239, 3), -1.23);
    for (double v = 1e-9; v < 1e9; v *= 1.37) {
        EXPECT_GE(rounded_up(v, 3), v);
        EXPECT_LT(rounded_up(v, 3), 1.011 * v);
    }
}

} // namespace
} // namespace trivar
