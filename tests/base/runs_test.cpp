// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/runs.h"

#include <gtest/gtest.h>
#include <numeric>

namespace trivar {
namespace {

std::vector<int> numbers(int count)
{
    std::vector<int> out(static_cast<std::size_t>(count));
    std::iota(out.begin(), out.end(), 0);
    return out;
}

TEST(Runs, HoldWhatWasAddedInItsOrder)
{
    Runs<int> runs;
    for (const int n : numbers(300)) runs.push_back(n);
    EXPECT_EQ(runs.size(), 300u);
    EXPECT_EQ(runs.all(), numbers(300));
    for (std::size_t i = 0; i < 300; ++i) EXPECT_EQ(runs[i], static_cast<int>(i));
    EXPECT_EQ(runs, Runs<int>(numbers(300))) << "wherever a run ends";
    EXPECT_EQ(runs, Runs<int>::cut(numbers(300)));
    EXPECT_FALSE(runs == Runs<int>(numbers(299)));
    EXPECT_TRUE(Runs<int>().empty());
}

TEST(Runs, FindElementsInRunsOfAnyLength)
{
    Runs<int> runs;
    std::vector<int> all;
    for (const int length : {3, 0, 500, 1, 1, 127, 2}) {
        runs.add(make_ref(numbers(length)));
        for (const int n : numbers(length)) all.push_back(n);
    }
    EXPECT_EQ(runs.runs().size(), 6u) << "none is empty";
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(runs[i], all[i]);
}

TEST(Runs, ShareWithTheirCopiesAllRunsButThoseThatChange)
{
    const Runs<int> before = Runs<int>::cut(numbers(1000));
    Runs<int> after = before;
    after.replace(300, -1);
    after.push_back(7);
    EXPECT_EQ(before.all(), numbers(1000));
    EXPECT_EQ(after[300], -1);
    EXPECT_EQ(after[1000], 7);
    std::size_t shared = 0;
    for (std::size_t r = 0; r < before.runs().size(); ++r)
        shared += before.runs()[r] == after.runs()[r];
    EXPECT_EQ(shared, before.runs().size() - 2);
}

} // namespace
} // namespace trivar
