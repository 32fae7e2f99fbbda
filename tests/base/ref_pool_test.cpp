// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/ref_pool.h"

#include <gtest/gtest.h>
#include <vector>

namespace trivar {
namespace {

using Numbers = std::vector<int>;

TEST(RefPool, GetsTheMemoryOfOneBackWhenNobodyHasIt)
{
    RefPool<Numbers> pool;
    Ref<Numbers> first = pool.lend(Numbers(1000, 1)), second = pool.lend(Numbers(10, 2));
    const int* const memory = first->data();
    EXPECT_FALSE(pool.take_back());
    Ref<Numbers> also = first;
    first = nullptr;
    EXPECT_FALSE(pool.take_back());
    also = nullptr;
    second = nullptr; // one is enough
    const std::optional<Numbers> back = pool.take_back();
    ASSERT_TRUE(back);
    EXPECT_EQ(back->data(), memory);
    EXPECT_FALSE(pool.take_back());
}

TEST(RefPool, MayEndBeforeWhatItLent)
{
    Ref<Numbers> left;
    {
        RefPool<Numbers> pool;
        left = pool.lend({1, 2});
    }
    EXPECT_EQ(*left, (Numbers{1, 2}));
}

} // namespace
} // namespace trivar
