// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/typed_amounts.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(TypedAmounts, TakeANumberAndLeaveTheAxesTheirKeys)
{
    TypedAmounts typed;
    for (const char c : std::string("g")) EXPECT_FALSE(typed.take(c));
    EXPECT_FALSE(typed.open());
    for (const char c : std::string("1.5cm")) EXPECT_TRUE(typed.take(c));
    EXPECT_FALSE(typed.take('x'));
    EXPECT_DOUBLE_EQ(*typed.value(0, Measure::length), 0.015);
    for (int i = 0; i < 9; ++i) typed.erase_last();
    EXPECT_FALSE(typed.open());
    for (const char c : std::string("=max(1,2)*")) EXPECT_TRUE(typed.take(c));
    EXPECT_EQ(typed.value(0, Measure::length), 2) << "what can be read so far counts";
    EXPECT_FALSE(typed.value(1, Measure::length));
}

} // namespace
} // namespace trivar
