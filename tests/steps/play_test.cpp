// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/stages/walk.h"
#include "core/steps/moving/posing.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::HasSubstr;
using testing::small_document, testing::TemporaryFolder;

// The small document with the rigged bar as object 5, laid on the table.
class Play : public ::testing::Test {
protected:
    Play()
    {
        testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(testing::rigged_model()));
        ImportModel import;
        import.file.path = "bar.gltf";
        import.file.up = UpAxis::z;
        import.file.scale = 0.2;
        import.name = "Bar";
        standing_ = after(small_document(), import);
        PlacementParameters p;
        p.fill = 0.4;
        laid_ = after(standing_, Place{5, testing::small_sketch(), p, {1}});
    }
    Evaluator evaluator() const
    {
        return Evaluator(std::make_shared<const AssetStore>(folder_.path().string()));
    }
    static Document playing(const Document& document, const Playing& playing)
    {
        return after(document, PlayClip{{5}, playing});
    }
    TemporaryFolder folder_;
    Document standing_, laid_;
};

TEST_F(Play, MovesWhatStandsAndWhatLiesInAVolume)
{
    for (const Document& document : {standing_, laid_})
        for (const char* clip : {"bend", "swell"}) {
            Evaluator evaluate = evaluator();
            const Document moving = playing(document, {.clip = clip});
            const Evaluation first = evaluate(moving, 1), later = evaluate(moving, 13);
            EXPECT_EQ(first.objects.at(5)->rejected, "");
            EXPECT_NE(digest(first), digest(later)) << clip;
            EXPECT_EQ(first.objects.at(1), later.objects.at(1));
            EXPECT_EQ(first.objects.at(5)->placement, later.objects.at(5)->placement);
            EXPECT_THAT(first.objects.at(5)->clips, ::testing::ElementsAre("bend", "swell"));
        }
}

TEST_F(Play, AnyFrameIsTheSameDirectlyAndAfterPlaying)
{
    const Document document =
        after(playing(laid_, {.clip = "bend", .speed = 0.7, .repeat = Repeat::back_and_forth}),
              SetTravel{{5}, {.speed = 0.3, .ends = Ends::loop}});
    Evaluator playing = evaluator();
    for (int frame = 1; frame < 40; frame += 6) digest(playing(document, frame));
    const std::string at_40 = digest(playing(document, 40));
    EXPECT_EQ(digest(evaluator()(document, 40)), at_40);
    const ThreadLimit one(1);
    EXPECT_EQ(digest(evaluator()(document, 40)), at_40);
    EXPECT_NE(digest(evaluator()(document, 41)), at_40);
}

TEST_F(Play, AClipThatStandsStillKeepsEveryBit)
{
    Evaluator evaluate = evaluator();
    const Document slow = playing(laid_, {.clip = "bend", .speed = 0});
    EXPECT_EQ(digest(evaluate(slow, 50)), digest(evaluate(laid_, 50)));
    const Document late = playing(laid_, {.clip = "bend", .start_frame = 20});
    EXPECT_EQ(digest(evaluate(late, 20)), digest(evaluate(laid_, 1)));
    EXPECT_NE(digest(evaluate(late, 21)), digest(evaluate(laid_, 1)));
    EXPECT_EQ(digest(playing(laid_, {})), digest(laid_)) << "logs without clips keep their digest";
}

TEST_F(Play, GoesOnAfterTheEndAsItIsTold)
{
    const Clip clip = testing::rigged_model().clips[0];
    const auto at = [&](Repeat repeat, double seconds) {
        return clip_time_s(clip, {.clip = "bend", .speed = 2, .repeat = repeat, .offset = 0.25},
                           seconds);
    };
    EXPECT_DOUBLE_EQ(at(Repeat::loop, -7), 0.25);
    EXPECT_DOUBLE_EQ(at(Repeat::loop, 0.25), 0.75);
    EXPECT_DOUBLE_EQ(at(Repeat::loop, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(at(Repeat::once, 5), 1);
    EXPECT_DOUBLE_EQ(at(Repeat::back_and_forth, 0.5), 0.75);
    EXPECT_DOUBLE_EQ(clip_time_s(clip, {.speed = -1, .repeat = Repeat::once}, 3), 0);
    EXPECT_DOUBLE_EQ(clip_time_s(clip, {.speed = -1}, 0.25), 0.75);
}

TEST_F(Play, SaysWhereNothingMoves)
{
    const auto notices = [&](std::size_t clip, auto&& change) {
        Model model = testing::rigged_model();
        change(model.clips[clip].channels[0]);
        testing::write_file(folder_.file("bar.gltf"), testing::gltf_text(model));
        const Evaluation at = evaluator()(playing(laid_, {.clip = model.clips[clip].name}), 5);
        EXPECT_EQ(at.objects.at(5)->rejected, "");
        return at.objects.at(5)->notices;
    };
    EXPECT_THAT(notices(0, [](Channel&) {}), ::testing::IsEmpty());
    EXPECT_THAT(notices(0,
                        [](Channel& c) {
                            for (std::size_t i = 0; i < c.values.size(); ++i)
                                c.values[i] = c.values[i % 4];
                        }),
                Contains(HasSubstr("nothing moves in \"bend\"")));
    EXPECT_THAT(notices(1,
                        [](Channel& c) {
                            c.times_s = {0.5f};
                            c.values = {0.75f};
                        }),
                Contains(HasSubstr("\"swell\" has no length")));
}

TEST_F(Play, SaysWhichClipsThereAreAndWhatHasNone)
{
    const Evaluation result = evaluator()(playing(laid_, {.clip = "dance"}), 1);
    EXPECT_THAT(result.objects.at(5)->notices,
                Contains(HasSubstr("no clip \"dance\"; it has bend, swell")));
    try {
        after(laid_, PlayClip{{2}, {.clip = "bend"}});
        FAIL();
    } catch (const Rejected& why) {
        EXPECT_THAT(why.what(), HasSubstr("not an imported model"));
    }
    EXPECT_THROW(after(laid_, PlayClip{{5}, {}, {{}, {}}}), Rejected);
}

TEST_F(Play, CyclesThatGoNowhereAreSaidAndPlayByTheClock)
{
    const auto travelling = [&](const Playing& how) {
        return after(playing(laid_, how), SetTravel{{5}, {.speed = 0.3, .ends = Ends::loop}});
    };
    for (const char* clip : {"bend", "swell"}) {
        const Document locked = travelling({.clip = clip, .foot_lock = true});
        const Evaluation result = evaluator()(locked, 9);
        EXPECT_THAT(result.objects.at(5)->notices, Contains(HasSubstr("its feet are not locked")));
        EXPECT_EQ(digest(result), digest(evaluator()(travelling({.clip = clip}), 9)));
    }
    Clip still;
    still.begin_s = still.end_s = 2;
    EXPECT_EQ(clip_time_s(still, {}, 7), 2);
}

TEST_F(Play, IsCopiedWithTheObject)
{
    const Document document = playing(laid_, {.clip = "swell", .speed = 3});
    const Document pasted = after(document, copied(document, {5}, folder_.path().string()));
    EXPECT_EQ(object(pasted, 6).playing, object(document, 5).playing);
}

TEST_F(Play, WhatIsSubdividedStandsAndSaysSo)
{
    EditImport edit{5, std::get<ImportedFile>(object(laid_, 5).source)};
    edit.file.subdivisions = 1;
    const Evaluation result = evaluator()(playing(after(laid_, edit), {.clip = "swell"}), 10);
    EXPECT_THAT(result.objects.at(5)->notices, Contains(HasSubstr("stays in its rest pose")));
    EXPECT_EQ(result.objects.at(5)->rejected, "");
}

} // namespace
} // namespace trivar
