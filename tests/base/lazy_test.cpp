// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/lazy.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>
#include <vector>

namespace trivar {
namespace {

TEST(Lazy, IsWorkedOutOnceForAllCopiesAndThreads)
{
    std::atomic<int> calls = 0;
    const Lazy<int> value([&calls] {
        ++calls;
        return 7;
    });
    const Lazy<int> copy = value;
    EXPECT_FALSE(copy.ready());
    EXPECT_EQ(calls, 0);
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i) threads.emplace_back([&] { EXPECT_EQ(*value, 7); });
    }
    EXPECT_TRUE(copy.ready());
    EXPECT_EQ(*copy, 7);
    EXPECT_EQ(calls, 1);
}

TEST(Lazy, TriesAgainAfterAnError)
{
    int calls = 0;
    const Lazy<int> value([&calls] {
        if (++calls == 1) throw std::runtime_error("not yet");
        return 7;
    });
    EXPECT_THROW(*value, std::runtime_error);
    EXPECT_FALSE(value.ready());
    EXPECT_EQ(*value, 7);
}

} // namespace
} // namespace trivar
