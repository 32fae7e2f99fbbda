// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/shaper.h"
#include "tests/support/scenes/commands.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::small_document;

// The pot (3) lies on the table in the small document.
class VolumeShape : public ::testing::Test {
protected:
    static Press press() { return {.radius = 0.5, .samples = {{0.5, 0.5, 1, 0.05}}}; }
    static Document pressed() { return after(small_document(), PressVolume{3, press()}); }
    static const EvaluatedObject& shown(const Evaluation& evaluated)
    {
        return *evaluated.objects.at(3);
    }
    Evaluator evaluate_{std::make_shared<const AssetStore>("/nowhere")};
};

TEST_F(VolumeShape, ChangesTheModelAndComesBackByUndo)
{
    const Evaluation before = evaluate_(small_document()), after = evaluate_(pressed());
    ASSERT_TRUE(shown(before).placement);
    EXPECT_FALSE(shown(before).shaped);
    ASSERT_TRUE(shown(after).shaped);
    EXPECT_GT(shown(after).shaped->steps.front().done, 0);
    EXPECT_NE(digest(before), digest(after));
    EXPECT_EQ(before.objects.at(1), after.objects.at(1));
    EXPECT_EQ(digest(evaluate_(small_document())), digest(before));
}

TEST_F(VolumeShape, FollowsTheStrokeWhereverThatGoes)
{
    PlacementParameters wide = object(small_document(), 3).stroke->parameters;
    wide.width = 0.5;
    const Document moved = after(pressed(), EditPlacement{3, wide, {}, {}});
    EXPECT_EQ(object(moved, 3).shaping.size(), 1u);
    const Evaluation evaluated = evaluate_(moved);
    EXPECT_GT(shown(evaluated).shaped->steps.front().done, 0);
    EXPECT_NE(digest(evaluated),
              digest(evaluate_(after(small_document(), EditPlacement{3, wide, {}, {}}))));
}

TEST_F(VolumeShape, GoesWithTheVolumeThatItWasOf)
{
    EXPECT_TRUE(object(after(pressed(), Unplace{3}), 3).shaping.empty());
    const PlacementStep step = *object(small_document(), 3).stroke;
    EXPECT_TRUE(
        object(after(pressed(), Place{3, step.sketch, step.parameters, {}}), 3).shaping.empty());
}

TEST_F(VolumeShape, IsCopiedByDuplicateAndPaste)
{
    const Document twice = after(pressed(), Duplicate{.objects = {3}});
    EXPECT_EQ(object(twice, twice.next_id - 1).shaping, object(twice, 3).shaping);
    const Document pasted = after(pressed(), copied(pressed(), {3}, "/models"));
    const Object& copy = object(pasted, pasted.next_id - 1);
    ASSERT_EQ(copy.shaping.size(), 1u);
    EXPECT_EQ(*copy.shaping.front(), *object(pasted, 3).shaping.front());
}

TEST_F(VolumeShape, StepsAreTakenBackOneByOneOrAll)
{
    Document document = after(pressed(), MendVolume{3});
    document = after(document, InsertKnots{3, {.along = {0.5}}});
    const Document without = after(document, Unshape{3, {1, 3}});
    ASSERT_EQ(object(without, 3).shaping.size(), 1u);
    EXPECT_TRUE(object(without, 3).shaping.front()->mending);
    EXPECT_TRUE(object(after(document, Unshape{3, {}}), 3).shaping.empty());
    EXPECT_THROW(after(document, Unshape{3, {4}}), Rejected);
}

TEST_F(VolumeShape, MayFoldWhereThatIsAllowedAndNowhereElse)
{
    const MovePoints far{3, {.points = {{16, 4, 3}}, .by = {1, 0, 0}}};
    const auto done = [&](const Document& document) {
        const Evaluation evaluated = evaluate_(after(document, far));
        const ShapedVolume& shaped = *shown(evaluated).shaped;
        EXPECT_TRUE((*shaped.volume->verdicts).good());
        EXPECT_TRUE(shown(evaluated).placement->report.folds.empty());
        return shaped.steps.back().done;
    };
    const auto allowed = [](const Document& document, std::vector<VolumePart> boxes) {
        return after(document, AllowFolds{3, {std::move(boxes)}});
    };
    const double stopped = done(small_document());
    EXPECT_LT(stopped, 1);
    const Document everywhere = allowed(small_document(), {{{0, 0, 0}, {1, 1, 1}}});
    EXPECT_EQ(done(everywhere), 1);
    EXPECT_EQ(done(allowed(everywhere, {})), stopped);
    EXPECT_EQ(done(allowed(small_document(), {{{0, 0, 0}, {0.2, 1, 1}}})), stopped);
    EXPECT_EQ(done(allowed(allowed(small_document(), {{{0, 0, 0}, {0.6, 1, 1}}}),
                           {{{0.5, 0, 0}, {1, 1, 1}}})),
              1);
    EXPECT_THROW(allowed(small_document(), {{{0, 0, 0}, {1, 1, 0}}}), Rejected);
    EXPECT_THROW(allowed(small_document(), {{{0, -1, 0}, {1, 1, 1}}}), Rejected);
}

TEST_F(VolumeShape, OfWhatIsNotPlacedIsRefusedAndSoIsWhatCannotBe)
{
    EXPECT_THROW(after(small_document(), PressVolume{1, press()}), Rejected);
    EXPECT_THROW(after(small_document(), PressVolume{3, Press{}}), Rejected);
    EXPECT_THROW(after(small_document(), MovePoints{3, {}}), Rejected);
    EXPECT_THROW(after(small_document(), InsertKnots{3, {}}), Rejected);
    EXPECT_THROW(after(small_document(), InsertKnots{3, {.up = {1}}}), Rejected);
    Paste paste = copied(pressed(), {3}, "/models");
    VolumeEdit two_at_once = *paste.copies.front().value.shaping.front();
    two_at_once.mending = Mending{};
    paste.copies.front().value.shaping.front() = make_ref(two_at_once);
    EXPECT_THROW(after(small_document(), paste), Rejected);
}

TEST_F(VolumeShape, ThatFitsNoMoreIsPassedOverAndSaid)
{
    const Document document =
        after(pressed(), MovePoints{3, {.points = {{500, 0, 0}}, .by = {0, 0, 0.1}}});
    const Evaluation evaluated = evaluate_(document);
    ASSERT_FALSE(shown(evaluated).notices.empty());
    EXPECT_NE(shown(evaluated).notices.back().find("step 2"), std::string::npos);
    EXPECT_EQ(digest(evaluated), digest(evaluate_(pressed())));
}

} // namespace
} // namespace trivar
