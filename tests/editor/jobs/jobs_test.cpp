// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/job.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

#include <gmock/gmock.h>
#include <thread>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr;

// Jobs whose frame thread is this one.
struct FramedJobs : ::testing::Test {
    std::vector<std::string> heard;
    Jobs jobs{[] {}};

    Jobs::Job saying(const std::string& word)
    {
        return {word,
                [this, word](const Progress&) -> Jobs::Finish {
                    return [this, word] { heard.push_back(word); };
                },
                [this, word](const std::string& why) { heard.push_back(word + " lost: " + why); }};
    }
    template <class Trouble> Jobs::Job throwing(const std::string& word, Trouble trouble)
    {
        Jobs::Job job = saying(word);
        job.work = [trouble](const Progress&) -> Jobs::Finish { throw trouble; };
        return job;
    }
    // Polls until no job runs; what is thrown meanwhile is heard, too.
    void wait()
    {
        do {
            std::this_thread::yield();
            try {
                jobs.poll();
            } catch (const std::exception& trouble) {
                heard.push_back(std::string("thrown: ") + trouble.what());
            }
        } while (jobs.status());
        jobs.poll();
    }
};

TEST_F(FramedJobs, RunOneAfterAnotherInTheirOrder)
{
    for (const char* word : {"one", "two", "three"}) jobs.start(saying(word));
    wait();
    EXPECT_THAT(heard, ElementsAre("one", "two", "three"));
}

TEST_F(FramedJobs, TellWhatIsWrongWithDataAndThrowMistakesOnTheFrameThread)
{
    jobs.start(throwing("a", Rejected("it has no faces")));
    jobs.start(throwing("b", std::bad_alloc()));
    jobs.start(throwing("c", Mistake("it broke")));
    jobs.start(saying("d"));
    wait();
    wait();
    ASSERT_EQ(heard.size(), 5u);
    EXPECT_EQ(heard[0], "a lost: it has no faces");
    EXPECT_THAT(heard[1], HasSubstr("b lost: There is not enough memory"));
    EXPECT_THAT(heard[2], HasSubstr("c lost: Trivar made a mistake here: it broke"));
    EXPECT_EQ(heard[3], "thrown: it broke");
    EXPECT_EQ(heard[4], "d");
}

TEST_F(FramedJobs, GoOnAfterAFinishThatThrows)
{
    Jobs::Job bad = saying("bad");
    bad.work = [](const Progress&) -> Jobs::Finish { return [] { throw Mistake("at the end"); }; };
    jobs.start(std::move(bad));
    jobs.start(saying("next"));
    wait();
    wait();
    EXPECT_THAT(heard, ElementsAre("thrown: at the end", "next"));
}

TEST_F(FramedJobs, StopTheJobThatIsCancelledWithoutAWord)
{
    Jobs::Job endless = saying("endless");
    endless.work = [](const Progress& progress) -> Jobs::Finish {
        for (;;) progress(0.5, "going round");
    };
    jobs.start(std::move(endless));
    jobs.start(saying("next"));
    jobs.cancel();
    wait();
    EXPECT_THAT(heard, ElementsAre("next"));
}

TEST(Jobs, ThatGoEndTheRunningJobAndForgetTheOthers)
{
    bool other = false;
    {
        Jobs jobs([] {});
        jobs.start({"endless",
                    [](const Progress& progress) -> Jobs::Finish {
                        for (;;) progress(0.5, "going round");
                    },
                    nullptr});
        jobs.start({"other",
                    [&other](const Progress&) -> Jobs::Finish {
                        other = true;
                        return {};
                    },
                    nullptr});
    }
    EXPECT_FALSE(other);
}

} // namespace
} // namespace trivar
