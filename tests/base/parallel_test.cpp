// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>
#include <xmmintrin.h>

namespace trivar {
namespace {

using Blocks = std::vector<std::pair<std::size_t, std::size_t>>;

Blocks blocks_of(std::size_t count, std::size_t block)
{
    std::mutex mutex;
    Blocks seen;
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        const std::lock_guard lock(mutex);
        seen.emplace_back(begin, end);
    });
    std::sort(seen.begin(), seen.end());
    return seen;
}

TEST(ParallelBlocks, CoverTheRangeOnce)
{
    for (const std::size_t count : {1u, 7u, 64u, 1000u})
        for (const std::size_t block : {1u, 7u, 64u, 5000u}) {
            std::size_t next = 0;
            for (const auto& [begin, end] : blocks_of(count, block)) {
                EXPECT_EQ(begin, next);
                EXPECT_LE(end - begin, block);
                next = end;
            }
            EXPECT_EQ(next, count);
        }
    EXPECT_TRUE(blocks_of(0, 8).empty());
}

TEST(ParallelBlocks, ComputeAsTheThreadThatCallsNowWhateverItDidBefore)
{
    constexpr unsigned flushing = 0x8040; // the least numbers to 0
    const auto flushed_blocks = [] {
        std::atomic<int> count = 0;
        parallel_blocks(200, 1, [&](std::size_t, std::size_t) {
            count += (_mm_getcsr() & flushing) != 0 ? 1 : 0;
        });
        return count.load();
    };
    std::thread([&] {
        const unsigned usual = _mm_getcsr();
        _mm_setcsr(usual | flushing);
        EXPECT_EQ(flushed_blocks(), 200);
        _mm_setcsr(usual);
        EXPECT_EQ(flushed_blocks(), 0);
    }).join();
}

TEST(ParallelBlocks, AreTheSameForAnyNumberOfThreads)
{
    const auto sums = [](int threads) {
        const ThreadLimit limit(threads);
        std::vector<double> out(100);
        parallel_blocks(10000, 100, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                out[begin / 100] += std::sin(static_cast<double>(i));
        });
        return std::accumulate(out.begin(), out.end(), 0.0);
    };
    const double once = sums(1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(sums(threads), once);
    EXPECT_EQ(blocks_of(1000, 33).size(), 31u);
}

TEST(ParallelBlocks, LetAnExceptionThrough)
{
    for (const std::size_t count : {10u, 1000u})
        EXPECT_THROW(parallel_blocks(count, 10,
                                     [](std::size_t begin, std::size_t) {
                                         if (begin == 0) throw Cancelled();
                                     }),
                     Cancelled);
}

TEST(ThreadLimit, OfOneOrLessIsThisThreadAlone)
{
    for (const int threads : {1, 0, -3}) {
        const ThreadLimit limit(threads);
        int running = 0, most = 0; // safe without locks only while there is one thread
        parallel_blocks(200, 1, [&](std::size_t, std::size_t) {
            most = std::max(most, ++running);
            --running;
        });
        EXPECT_EQ(most, 1);
    }
}

} // namespace
} // namespace trivar
