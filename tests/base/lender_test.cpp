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
    Numbers value;
    lender.take_back(value);
    EXPECT_TRUE(value.empty());
    Ref<Numbers> also = first;
    first = nullptr;
    lender.take_back(value);
    EXPECT_TRUE(value.empty());
    also = nullptr;
    second = nullptr; // one is enough
    lender.take_back(value);
    EXPECT_EQ(value.data(), memory);
    lender.take_back(value);
    EXPECT_EQ(value.data(), memory);
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
