// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/simplify.h"
#include "editor/jobs/background_evaluator.h"

#include "core/commands/command.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// Evaluators whose frame thread is this one.
struct FramedEvaluator : ::testing::Test {
    std::atomic<int> woken = 0;
    BackgroundEvaluator evaluator{std::make_shared<const AssetStore>("/nowhere"),
                                  [this] { ++woken; }};

    BackgroundEvaluator::Result result_of(long ticket)
    {
        for (;;) {
            if (auto result = evaluator.poll(); result && result->ticket == ticket)
                return std::move(*result);
            std::this_thread::yield();
        }
    }
    static Document boxes(int count)
    {
        Document document;
        for (int i = 0; i < count; ++i) document = after(document, AddBox{});
        return document;
    }
};

TEST_F(FramedEvaluator, GivesWhatAnEvaluatorGives)
{
    const long ticket = evaluator.submit(boxes(3), 1);
    const BackgroundEvaluator::Result result = result_of(ticket);
    EXPECT_TRUE(result.problem.empty());
    EXPECT_EQ(digest(result.evaluated),
              digest(Evaluator(std::make_shared<const AssetStore>("/nowhere"))(boxes(3))));
    EXPECT_GT(woken, 0);
    EXPECT_FALSE(evaluator.poll()) << "it was taken";
}

TEST_F(FramedEvaluator, GivesTheNewestOfManyAndThatAlways)
{
    long ticket = 0;
    for (int i = 1; i <= 40; ++i) {
        const long next = evaluator.submit(boxes(i), 1);
        EXPECT_EQ(next, ticket + 1);
        ticket = next;
    }
    EXPECT_EQ(result_of(ticket).evaluated.objects.size(), 40u);
    EXPECT_FALSE(evaluator.status().busy);
}

TEST_F(FramedEvaluator, IsStoppedWithAProblemAndEvaluatesWhatComesThen)
{
    AddPlane plane;
    plane.shape.segments = {256, 256};
    Document heavy = after(Document{}, plane);
    heavy = after(heavy, Simplify{{1}, {}});
    const long ticket = evaluator.submit(heavy, 1);
    while (evaluator.status().stage.empty()) std::this_thread::yield();
    evaluator.cancel();
    const BackgroundEvaluator::Result result = result_of(ticket);
    EXPECT_EQ(result.stopped, !result.problem.empty());
    EXPECT_FALSE(result.mistake);
    EXPECT_EQ(result_of(evaluator.submit(boxes(2), 1)).evaluated.objects.size(), 2u);
}

TEST_F(FramedEvaluator, GoesWhileItWorks)
{
    evaluator.submit(boxes(400), 1);
}

} // namespace
} // namespace trivar
