// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/field_rows.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(NumberStyle, OfAFactorFollowsItsValueAndThatOfAShareItsRange)
{
    const ui::NumberStyle factor = number_style(in_range(0, 100).in(Unit::times), false, {});
    EXPECT_LT(factor.bar_hi, factor.lo);
    EXPECT_EQ(factor.usual, 1);
    EXPECT_EQ(factor.hi, 100);
    const ui::NumberStyle share = number_style(in_range(0, 1).in(Unit::share), false, {});
    EXPECT_EQ(share.bar_hi, 100);
}

} // namespace
} // namespace trivar
