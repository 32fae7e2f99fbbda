// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of objects that end by an exception.
#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/placement/place.h"
#include "core/steps/lacking.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>
#include <new>
#include <set>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty;

Evaluator evaluator_that(OnFailure on_failure)
{
    return Evaluator(std::make_shared<const AssetStore>("."), ShutIncisions::vanish, on_failure);
}

Document refined_pot()
{
    return after(testing::small_document(), Refine{{3}, {.tolerance = 1e-3}});
}

Document scene_with_every_step()
{
    return after(after(after(testing::fitting_document(), Refine{{3}, {.tolerance = 1e-3}}),
                       Simplify{{1}, {}}),
                 Unwrap{{2}, {}});
}

template <class Trouble> Progress throwing_at(std::string stage, Trouble trouble)
{
    return [=](double, std::string_view now) {
        if (now == stage) throw trouble;
    };
}

TEST(FailedStep, EndsTheEvaluationOfATest)
{
    Evaluator evaluate = evaluator_that(OnFailure::pass_on);
    EXPECT_THROW(evaluate(refined_pot(), 1, throwing_at("refining", Mistake("a"))), Mistake);
}

TEST(FailedStep, IsLeftOutAndToldAndTheOthersAreAsEver)
{
    Evaluator evaluate = evaluator_that(OnFailure::leave_out);
    const Document document = refined_pot();
    const Evaluation result = evaluate(document, 1, throwing_at("refining", Mistake("it broke")));
    const Evaluation without = testing::new_evaluator()(testing::small_document());
    EXPECT_EQ(digest(result), digest(without)) << "the pot is as it was before it was refined";
    ASSERT_EQ(result.failed.size(), 1u);
    EXPECT_EQ(result.failed.front().object, 3);
    EXPECT_TRUE(result.failed.front().mistake);
    const EvaluatedObject& pot = *result.objects.at(3);
    ASSERT_FALSE(pot.notices.empty());
    EXPECT_EQ(pot.notices.back(), "Trivar made a mistake here: it broke. The step is kept, and the "
                                  "object is shown without it");
    EXPECT_THAT(lacks(result, document), ::testing::ElementsAre(HasSubstr("it broke")));
    EXPECT_THAT(result.objects.at(2)->notices, IsEmpty());
}

TEST(FailedStep, OfAHiddenHostIsLackingToo)
{
    Evaluator evaluate = evaluator_that(OnFailure::leave_out);
    AddTorus ring;
    ring.shape = {.radius = 0.1, .tube = 0.03, .segments = {24, 12}};
    Document document =
        after(after(refined_pot(), ring), Place{5, testing::small_sketch(), {}, {3}});
    document = after(document, Hide{{3}});
    const Evaluation result = evaluate(document, 1, throwing_at("refining", Mistake("it broke")));
    EXPECT_THAT(lacks(result, document), ::testing::Contains(HasSubstr("it broke")));
}

TEST(FailedStep, OfMemoryIsNoMistakeAndCancellingIsNone)
{
    Evaluator evaluate = evaluator_that(OnFailure::leave_out);
    const Evaluation result = evaluate(refined_pot(), 1, throwing_at("refining", std::bad_alloc()));
    ASSERT_EQ(result.failed.size(), 1u);
    EXPECT_FALSE(result.failed.front().mistake);
    EXPECT_THAT(result.failed.front().words, HasSubstr("not enough memory"));
    Evaluator another = evaluator_that(OnFailure::leave_out);
    EXPECT_THROW(another(refined_pot(), 1, throwing_at("refining", Cancelled())), Cancelled);
}

TEST(FailedStep, KeepsItsPointersWhileItFailsInTheSameWay)
{
    Evaluator evaluate = evaluator_that(OnFailure::leave_out);
    const Progress broken = throwing_at("refining", Mistake("a"));
    const Evaluation first = evaluate(refined_pot(), 1, broken);
    EXPECT_EQ(evaluate(refined_pot(), 1, broken).objects, first.objects);
}

// Whatever step ends in the middle, the next evaluation gives what a new evaluator gives.
TEST(FailedStep, LeavesNothingHalfMadeInTheCaches)
{
    const Document document = scene_with_every_step();
    std::set<std::string> names;
    for (const auto& [id, object] : document.objects) names.insert(object->name);
    const auto counting = [&](int& calls, int wanted) {
        return [&names, &calls, wanted](double, std::string_view stage) {
            if (!names.contains(std::string(stage)) && calls++ == wanted) throw Mistake("a");
        };
    };
    int all = 0;
    const std::string expected = digest(testing::new_evaluator()(document, 1, counting(all, -1)));
    ASSERT_GT(all, 10);
    constexpr int rounds = 12;
    for (int k = 0; k < rounds; ++k) {
        const int wanted = k * (all - 1) / (rounds - 1);
        Evaluator evaluate = evaluator_that(OnFailure::leave_out);
        int calls = 0;
        const Evaluation broken = evaluate(document, 1, counting(calls, wanted));
        EXPECT_EQ(broken.failed.empty(), calls <= wanted) << "a step that reports less often";
        const Evaluation again = evaluate(document);
        EXPECT_THAT(again.failed, IsEmpty());
        EXPECT_EQ(digest(again), expected) << wanted << " of " << all;
    }
}

} // namespace
} // namespace trivar
