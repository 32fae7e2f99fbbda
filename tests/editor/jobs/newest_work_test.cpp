// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/newest_work.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <future>
#include <gtest/gtest.h>

namespace trivar {
namespace {

void wait_until(NewestWork& work)
{
    while (work.busy()) {
        work.poll();
        std::this_thread::yield();
    }
}

TEST(NewestWork, TakesInTheNewestOfWhatCameAndNothingElse)
{
    NewestWork work;
    std::vector<int> taken;
    std::promise<void> begun;
    work.start([&](const Progress& progress) -> NewestWork::Finish {
        begun.set_value();
        for (;;) progress(0, {}); // till it is old
    });
    begun.get_future().wait();
    for (const int number : {1, 2, 3})
        work.start([&taken, number](const Progress&) -> NewestWork::Finish {
            return [&taken, number] { taken.push_back(number); };
        });
    wait_until(work);
    EXPECT_EQ(taken, std::vector<int>{3});
}

TEST(NewestWork, HearsNothingOfWhatWasDropped)
{
    NewestWork work;
    work.start([](const Progress&) -> NewestWork::Finish { throw Mistake("nobody asks"); });
    work.drop();
    EXPECT_FALSE(work.busy());
    EXPECT_FALSE(work.poll());
}

TEST(NewestWork, ThrowsAMistakeWhereItIsPolledAndGoesOn)
{
    NewestWork work;
    work.start([](const Progress&) -> NewestWork::Finish { throw Mistake("it broke"); });
    EXPECT_THROW(wait_until(work), Mistake);
    EXPECT_FALSE(work.busy());
    bool done = false;
    work.start([&done](const Progress&) -> NewestWork::Finish { return [&done] { done = true; }; });
    wait_until(work);
    EXPECT_TRUE(done);
}

TEST(NewestWork, GivesNothingWhereDataAreRejected)
{
    NewestWork work;
    work.start([](const Progress&) -> NewestWork::Finish { throw Rejected("no"); });
    EXPECT_NO_THROW(wait_until(work));
}

} // namespace
} // namespace trivar
