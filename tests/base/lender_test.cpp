// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/lender.h"

#include <gtest/gtest.h>
#include <vector>

namespace trivar {
namespace {

using Numbers = std::vector<int>;

TEST(Lender, GetsTheMemoryOfOneBackWhenNobodyHasIt)
{
    Lender<Numbers> lender;
    Ref<Numbers> first = lender.lend(Numbers(1000, 1)), second = lender.lend(Numbers(10, 2));
    const int* const memory = first->data();
    EXPECT_FALSE(lender.take_back());
    Ref<Numbers> also = first;
    first = nullptr;
    EXPECT_FALSE(lender.take_back());
    also = nullptr;
    second = nullptr; // one is enough
    const std::optional<Numbers> back = lender.take_back();
    ASSERT_TRUE(back);
    EXPECT_EQ(back->data(), memory);
    EXPECT_FALSE(lender.take_back());
}

TEST(Lender, MayEndBeforeWhatItLent)
{
    Ref<Numbers> left;
    {
        Lender<Numbers> lender;
        left = lender.lend({1, 2});
    }
    EXPECT_EQ(*left, (Numbers{1, 2}));
}

} // namespace
} // namespace trivar
