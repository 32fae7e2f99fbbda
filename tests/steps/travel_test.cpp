// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/view.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::new_evaluator, testing::small_document, testing::small_sketch;

// The teapot fills a fifth of its stroke and travels.
Document with_travel(const Travel& travel)
{
    PlacementParameters p;
    p.fill = 0.2;
    return after(after(small_document(), EditPlacement{3, p, {}, {}}), SetTravel{{3}, travel});
}

std::string shown(Evaluator& evaluate, const Document& document, double frame)
{
    return digest(evaluate(document, frame));
}

TEST(Travel, AnyFrameIsTheSameDirectlyAndAfterPlaying)
{
    for (const Ends ends : {Ends::stay, Ends::run_on, Ends::loop, Ends::back_and_forth}) {
        const Document document = with_travel({.speed = 0.4, .ends = ends, .ease_in = 0.5});
        Evaluator playing = new_evaluator();
        std::string at_60;
        for (int frame = 1; frame <= 60; frame += 7) shown(playing, document, frame);
        at_60 = shown(playing, document, 60);
        Evaluator direct = new_evaluator();
        EXPECT_EQ(shown(direct, document, 60), at_60);
        EXPECT_EQ(shown(direct, document, 1), shown(playing, document, 1)); // and back
        const ThreadLimit one(1);
        Evaluator alone = new_evaluator();
        EXPECT_EQ(shown(alone, document, 60), at_60);
        EXPECT_NE(shown(alone, document, 59), at_60);
    }
}

TEST(Travel, WithoutSpeedOrBeforeItSetsOutKeepsEveryBit)
{
    Evaluator evaluate = new_evaluator();
    const std::string at_rest = shown(evaluate, with_travel({}), 1);
    EXPECT_EQ(shown(evaluate, with_travel({.speed = 0, .ends = Ends::loop}), 50), at_rest);
    const Document later = with_travel({.speed = 1, .start_frame = 20});
    EXPECT_EQ(shown(evaluate, later, 20), at_rest);
    EXPECT_NE(shown(evaluate, later, 21), at_rest);
}

TEST(Travel, DeformsWhatMovesAndNothingElse)
{
    Evaluator evaluate = new_evaluator();
    const Document document = with_travel({.speed = 0.4});
    const Evaluation first = evaluate(document, 1), later = evaluate(document, 30);
    EXPECT_EQ(later.objects.at(1), first.objects.at(1));
    EXPECT_NE(later.objects.at(3), first.objects.at(3));
    EXPECT_EQ(later.objects.at(3)->placement, first.objects.at(3)->placement); // not laid again
    for (const Timings::Stage& stage : later.timings.stages) EXPECT_EQ(stage.name, "deform");
    EXPECT_EQ(evaluate(document, 30).objects.at(3), later.objects.at(3));
}

TEST(Travel, HidesWhatIsGoneAndSaysWhereThereIsNoRoom)
{
    Evaluator evaluate = new_evaluator();
    const Document document = with_travel({.speed = 10, .ends = Ends::hide});
    EXPECT_TRUE(evaluate(document, 240).objects.at(3)->parts.empty());
    EXPECT_FALSE(evaluate(document, 1).objects.at(3)->parts.empty());
    const Document full = after(small_document(), SetTravel{{3}, {.speed = 1}});
    EXPECT_THAT(evaluate(full).objects.at(3)->notices, ::testing::Contains(HasSubstr("no room")));
}

TEST(Travel, LaysWhatLiesOnAMovingThingAgain)
{
    AddTorus ring;
    ring.shape = {.radius = 0.1, .tube = 0.03, .segments = {24, 12}};
    Sketch sketch = small_sketch();
    for (StrokeSample& sample : sketch.samples) sample.p_px.x = 540 + (sample.p_px.x - 440) / 2;
    const Document document =
        after(after(with_travel({.speed = 0.4}), ring), Place{5, sketch, {}, {1, 3}});
    Evaluator evaluate = new_evaluator();
    const auto first = evaluate(document, 1).objects, later = evaluate(document, 40).objects;
    EXPECT_NE(first.at(5)->placement, later.at(5)->placement);
}

TEST(Travel, LeavesAStrokeAloneThatItDoesNotComeNear)
{
    AddTorus ring;
    ring.shape = {.radius = 0.1, .tube = 0.03, .segments = {24, 12}};
    Sketch aside = small_sketch();
    for (StrokeSample& sample : aside.samples) sample.p_px.y += 220;
    const Document document =
        after(after(with_travel({.speed = 0.4}), ring), Place{5, aside, {}, {1, 3}});
    Evaluator evaluate = new_evaluator();
    const auto first = evaluate(document, 1).objects, later = evaluate(document, 40).objects;
    ASSERT_TRUE(first.at(5)->placement);
    EXPECT_EQ(first.at(5), later.at(5));
}

TEST(Travel, FollowsTheClockAndNotTheFrames)
{
    Evaluator evaluate = new_evaluator();
    const Document document = with_travel({.speed = 0.4});
    const Document fast = after(document, SetTime{{1, 480, 48}});
    EXPECT_EQ(shown(evaluate, fast, 49), shown(evaluate, document, 25)); // a second later both
}

TEST(Travel, StaysWithAStrokeThatIsDrawnAnewAndGoesWithIt)
{
    const Document document = with_travel({.speed = 0.4});
    const Document again = after(document, Place{3, small_sketch(), {}, {1}});
    EXPECT_EQ(object(again, 3).travel, object(document, 3).travel);
    EXPECT_EQ(object(after(document, Unplace{3}), 3).travel, Travel{});
}

TEST(Travel, IsRefusedForWhatIsNotPlacedAndForNonsense)
{
    const auto why = [](const Command& command) -> std::string {
        try {
            after(small_document(), command);
        } catch (const Rejected& rejected) {
            return rejected.what();
        }
        return "";
    };
    EXPECT_THAT(why(SetTravel{{2}, {.speed = 1}}), HasSubstr("is not placed"));
    EXPECT_THAT(why(SetTravel{{3}, {.ease_in = -1}}), HasSubstr("ease_in"));
    EXPECT_THAT(why(SetTravel{{3}, {.speed = std::nan("")}}), HasSubstr("speed"));
    EXPECT_THAT(why(SetTime{{10, 9, 24}}), HasSubstr("before the first frame"));
    EXPECT_THAT(why(SetTime{{1, 9, 0}}), HasSubstr("frames_per_second"));
}

TEST(Travel, LetsFollowersShareTheVolumeAsOneObject)
{
    Evaluator evaluate = new_evaluator();
    PlacementParameters p;
    p.fill = 0.1;
    const Document document =
        after(after(small_document(), EditPlacement{3, p, {}, {}}),
              SetTravel{{3}, {.speed = 0.4, .ends = Ends::loop, .followers = 4}});
    const Ref<EvaluatedObject> alone = evaluate(with_travel({.speed = 0.4}), 20).objects.at(3);
    for (const double frame : {1.0, 20.0, 200.0}) {
        const Ref<EvaluatedObject> all = evaluate(document, frame).objects.at(3);
        ASSERT_EQ(all->parts.size(), 5 * alone->parts.size());
        for (const Part& part : all->parts) {
            EXPECT_EQ(part.bent->volume, all->parts.front().bent->volume);
            EXPECT_EQ(part.rest, all->parts.front().rest);
        }
        const ThreadLimit one(1);
        EXPECT_EQ(shown(evaluate, document, frame), digest(new_evaluator()(document, frame)));
    }
    const Document undone = after(document, SetTravel{{3}, {.speed = 0.4, .ends = Ends::loop}});
    EXPECT_EQ(evaluate(undone, 20).objects.at(3)->parts.size(), alone->parts.size());
    // They stand in their places also while they rest.
    const Document resting = after(document, SetTravel{{3}, {.ends = Ends::loop, .followers = 4}});
    EXPECT_EQ(evaluate(resting, 20).objects.at(3)->parts.size(), 5 * alone->parts.size());
    EXPECT_EQ(shown(evaluate, resting, 20), shown(evaluate, resting, 90));
}

TEST(PlaceRound, GoesRoundAndRoundAndMovesWithWhatItLiesOn)
{
    PlacementParameters p;
    p.fill = 0.2;
    const Document still = after(small_document(), PlaceRound{3, 2, 0.1, p});
    const Document document = after(still, SetTravel{{3}, {.speed = 0.4, .ends = Ends::loop}});
    Evaluator evaluate = new_evaluator();
    const Evaluation a = evaluate(document, 1), b = evaluate(document, 90);
    EXPECT_TRUE(a.objects.at(3)->rejected.empty());
    EXPECT_TRUE(a.objects.at(3)->notices.empty());
    EXPECT_NE(digest(a), digest(b));
    Transform aside = object(document, 2).transform;
    aside.translation.x += 5;
    const Evaluation moved = evaluate(after(document, SetTransform{2, aside}), 1);
    EXPECT_NEAR(moved.objects.at(3)->bounds->lo.x, a.objects.at(3)->bounds->lo.x + 5, 1e-5);
}

TEST(PlaceRound, GoesRoundAnyBodyWhereAPlaneCutsIt)
{
    PlacementParameters p;
    p.fill = 0.2;
    p.width = p.height = 0.2; // the table is half a metre thick
    const PlaceRound command{3, 1, 0.05, p, glm::dvec3(0, 0, 1)};
    EXPECT_EQ(command_from_json_line(to_json_line(command)), command);
    const Document document = after(small_document(), command);
    EXPECT_NE(digest(document),
              digest(after(small_document(), PlaceRound{3, 1, 0.05, p, glm::dvec3(0, 1, 0)})));
    Evaluator evaluated = new_evaluator();
    const Evaluation there = evaluated(document, 1);
    const EvaluatedObject& on_table = *there.objects.at(3);
    ASSERT_TRUE(on_table.placement) << on_table.rejected;
    EXPECT_TRUE(on_table.notices.empty());
    // The table is 4 x 4 m: it stands on a side of that, upright to it.
    EXPECT_NEAR(on_table.placement->report.length_world, 16, 0.1);
    const Lattice& volume = on_table.placement->volume;
    EXPECT_NEAR(evaluate(volume, {0.5, 0.5, 0}).value.x, -2, 0.1);
    EXPECT_LT(evaluate(volume, {0.5, 0.5, 1}).value.x, -2.1);
    // Copies of both lie so too, and those of it alone on what it lay on.
    const Document pasted = after(document, copied(document, {1, 3}, ""));
    const Object& copy = object(pasted, pasted.next_id - 1);
    ASSERT_TRUE(copy.stroke && copy.stroke->round);
    EXPECT_EQ(copy.stroke->round->normal, glm::dvec3(0, 0, 1));
    EXPECT_THROW(after(small_document(), PlaceRound{3, 1, 0, p, glm::dvec3(0)}), Rejected);
    const Evaluation over =
        evaluated(after(document, PlaceRound{3, 1, 2, p, glm::dvec3(0, 0, 1)}), 1);
    EXPECT_THAT(over.objects.at(3)->rejected, HasSubstr("does not cut"));
}

TEST(PlaceRound, SaysWhatItNeeds)
{
    const auto why = [](const Document& document, const Command& command) -> std::string {
        try {
            after(document, command);
        } catch (const Rejected& error) {
            return error.what();
        }
        return "";
    };
    const Document document = small_document();
    EXPECT_THAT(why(document, PlaceRound{3, 1, 0, {}}), HasSubstr("not a cylinder"));
    EXPECT_THAT(why(document, PlaceRound{2, 2, 0, {}}), HasSubstr("on itself"));
    const Document round = after(document, PlaceRound{3, 2, 0, {}});
    EXPECT_THAT(why(round, EditPlacement{3, {}, {}, std::vector<Id>{1}}), HasSubstr("place_round"));
    EXPECT_THAT(why(round, PlaceRound{2, 3, 0, {}}), HasSubstr("not a cylinder"));
    // The sphere itself laid down carries nothing round it any more; that is a notice.
    const Document laid = after(round, Place{2, small_sketch(), {}, {1}});
    EXPECT_THAT(new_evaluator()(laid).objects.at(3)->rejected, HasSubstr("free-standing"));
}

TEST(SetTravel, GivesOneEachOrOneForAll)
{
    Document document = testing::small_document();
    document = after(document, Place{2, testing::small_sketch(), {}, {1}});
    const SetTravel each{{3, 2}, {}, {{.speed = 1}, {.speed = 2}}};
    const Document done = after(document, each);
    EXPECT_EQ(object(done, 3).travel.speed, 1);
    EXPECT_EQ(object(done, 2).travel.speed, 2);
    EXPECT_THROW(after(document, SetTravel{{3, 2}, {}, {{.speed = 1}}}), Rejected);
}

} // namespace
} // namespace trivar
