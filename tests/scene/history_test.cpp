// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/history.h"

#include "core/base/rejected.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(History, ADragIsManyProposalsAndOneStep)
{
    History history;
    history.run(AddBox{});
    for (int i = 1; i <= 20; ++i) history.propose(SetTransform{1, {.translation = {i, 0, 0}}});
    EXPECT_EQ(object(history.document(), 1).transform.translation.x, 20);
    EXPECT_EQ(object(history.committed(), 1).transform.translation.x, 0);
    EXPECT_TRUE(history.commit());
    EXPECT_EQ(history.steps().size(), 2u);
    EXPECT_EQ(object(history.committed(), 1).transform.translation.x, 20);
}

TEST(History, CancelLeavesNoTrace)
{
    History history;
    history.run(AddBox{});
    const Ref<Object> before = history.document().objects.at(1);
    history.propose(Hide{{1}});
    history.cancel();
    EXPECT_EQ(history.document().objects.at(1), before);
    EXPECT_FALSE(history.commit());
}

TEST(History, ARejectedProposalKeepsTheOneBefore)
{
    History history;
    history.run(AddBox{});
    history.propose(Hide{{1}});
    EXPECT_THROW(history.propose(Hide{{2}}), Rejected);
    EXPECT_TRUE(object(history.document(), 1).hidden);
}

TEST(History, ANewStepForgetsWhatWasUndone)
{
    History history;
    history.run(AddBox{});
    history.run(AddSphere{});
    EXPECT_TRUE(history.undo());
    history.run(AddTorus{});
    EXPECT_FALSE(history.redo());
    EXPECT_EQ(object(history.document(), 2).name, "Torus");
}

TEST(History, TheCommandThatBeganABranchBringsItsStepsBack)
{
    History history;
    for (const Command& c : {Command(AddBox{}), Command(AddSphere{}), Command(AddTorus{})})
        history.run(c);
    const Document was = history.document();
    history.undo();
    history.undo();
    history.run(AddPlane{});
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_EQ(history.branches()[0].from, 1u);
    EXPECT_EQ(history.branches()[0].steps.size(), 2u);
    history.undo();
    history.run(AddSphere{});
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(history.document().objects.at(3), was.objects.at(3)) << "the very same";
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_EQ(history.branches()[0].steps.size(), 1u) << "the plane";
}

TEST(History, WhatLeftABranchComesBackWithIt)
{
    History history;
    history.run(AddBox{});
    history.run(AddSphere{});
    history.run(AddTorus{});
    history.undo();
    history.run(AddTeapot{}); // the torus left after two steps
    history.undo();
    history.undo();
    history.run(AddPlane{}); // sphere and teapot left after one
    ASSERT_EQ(history.branches().size(), 1u);
    ASSERT_EQ(history.branches()[0].others.size(), 1u);
    history.undo();
    history.run(AddSphere{});
    EXPECT_EQ(history.branches().size(), 2u);
    history.forget_undone();
    EXPECT_TRUE(history.branches().empty());
}

TEST(History, EndsAtBothEnds)
{
    History history;
    EXPECT_FALSE(history.undo());
    EXPECT_FALSE(history.redo());
    history.run(AddBox{});
    EXPECT_TRUE(history.undo());
    EXPECT_FALSE(history.undo());
    EXPECT_TRUE(history.document().objects.empty());
    EXPECT_TRUE(history.redo());
    EXPECT_FALSE(history.redo());
}

} // namespace
} // namespace trivar
