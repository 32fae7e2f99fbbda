// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/worker.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <future>
#include <gtest/gtest.h>

namespace trivar {
namespace {

// A worker whose frame thread is this one.
struct FramedWorker : ::testing::Test {
    std::atomic<int> woken = 0;
    std::vector<int> taken;
    std::promise<void> begun;
    std::atomic<bool> ended = false;
    Worker worker{[this] { ++woken; }};

    Worker::Work giving(int number)
    {
        return [this, number](const Progress&) -> Worker::Finish {
            return [this, number] { taken.push_back(number); };
        };
    }
    Worker::Work endless()
    {
        return [this](const Progress& progress) -> Worker::Finish {
            begun.set_value();
            try {
                for (;;) progress(0.5, "going round");
            } catch (const Cancelled&) {
                ended = true;
                throw;
            }
        };
    }
    void wait()
    {
        while (worker.busy()) {
            worker.poll();
            std::this_thread::yield();
        }
    }
};

TEST_F(FramedWorker, FinishesWhatRunsAndThenTheNewestOfWhatWaits)
{
    std::promise<void> go_on;
    worker.start([&](const Progress&) -> Worker::Finish {
        begun.set_value();
        go_on.get_future().wait();
        return [this] { taken.push_back(0); };
    });
    begun.get_future().wait();
    for (const int number : {1, 2, 3}) worker.start(giving(number));
    go_on.set_value();
    wait();
    EXPECT_EQ(taken, (std::vector<int>{0, 3}));
}

TEST_F(FramedWorker, GivesTheNewestOfManyAndThatAlways)
{
    for (int number = 0; number < 1000; ++number) {
        worker.start(giving(number));
        if (number % 3 == 0) worker.drop();
        if (number % 7 == 0) worker.poll();
    }
    worker.start(giving(1000));
    wait();
    EXPECT_EQ(taken.back(), 1000);
    EXPECT_TRUE(std::ranges::is_sorted(taken));
}

TEST_F(FramedWorker, EndsWhatIsDroppedAndHearsNothingOfIt)
{
    worker.start(endless());
    begun.get_future().wait();
    EXPECT_TRUE(worker.busy());
    EXPECT_FALSE(worker.poll());
    worker.drop();
    EXPECT_FALSE(worker.busy());
    worker.start(giving(2));
    wait();
    EXPECT_TRUE(ended);
    EXPECT_EQ(taken, std::vector<int>{2});
    worker.start([](const Progress&) -> Worker::Finish { throw Mistake("nobody asks"); });
    worker.drop();
    EXPECT_FALSE(worker.busy());
    EXPECT_FALSE(worker.poll());
}

TEST_F(FramedWorker, CancelsWhatRunsAndWhatWaitsWhichMayTellOfIt)
{
    worker.start(endless());
    begun.get_future().wait();
    worker.start([this](const Progress& progress) -> Worker::Finish {
        try {
            progress(0, "begun");
        } catch (const Cancelled&) {
            return [this] { taken.push_back(-1); };
        }
        return [this] { taken.push_back(1); };
    });
    worker.cancel();
    wait();
    EXPECT_TRUE(ended);
    EXPECT_EQ(taken, std::vector<int>{-1});
}

TEST_F(FramedWorker, ThrowsAMistakeWhereItIsPolledAndGoesOn)
{
    worker.start([](const Progress&) -> Worker::Finish { throw Mistake("it broke"); });
    EXPECT_THROW(wait(), Mistake);
    EXPECT_FALSE(worker.busy());
    worker.start(giving(1));
    wait();
    EXPECT_EQ(taken, std::vector<int>{1});
}

TEST_F(FramedWorker, GivesNothingWhereDataAreRejectedOrMemoryEnds)
{
    worker.start([](const Progress&) -> Worker::Finish { throw Rejected("no"); });
    EXPECT_NO_THROW(wait());
    worker.start([](const Progress&) -> Worker::Finish { throw std::bad_alloc(); });
    EXPECT_NO_THROW(wait());
    EXPECT_FALSE(worker.poll());
}

TEST_F(FramedWorker, TellsHowFarItIsAndWakesTheFrameThread)
{
    worker.start(endless(), "Going");
    EXPECT_EQ(worker.status().what, "Going");
    while (worker.status().stage.empty()) std::this_thread::yield();
    EXPECT_EQ(worker.status().fraction, 0.5);
    EXPECT_FALSE(worker.status().done);
    EXPECT_GT(woken, 0);
    const int before = woken;
    worker.cancel();
    wait();
    EXPECT_TRUE(worker.status().done);
    EXPECT_GT(woken, before);
}

TEST_F(FramedWorker, EndsWhatRunsWhereItGoes)
{
    {
        Worker own;
        own.start(endless());
        begun.get_future().wait();
        own.start(giving(1));
    }
    EXPECT_TRUE(ended);
    EXPECT_TRUE(taken.empty());
}

} // namespace
} // namespace trivar
