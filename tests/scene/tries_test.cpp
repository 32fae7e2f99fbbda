// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/scene/tries.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

SetTransform at(double x)
{
    return {1, {.translation = {x, 0, 0}}};
}
History box_moved_to(std::initializer_list<double> tries)
{
    History history;
    history.run(AddBox{});
    for (const double x : tries) {
        if (history.position() > 1) history.undo();
        history.run(at(x));
    }
    return history;
}

TEST(Tries, OfOneStepAreReplacedByTheLast)
{
    const History history = box_moved_to({1, 2, 3});
    ASSERT_EQ(history.branches().size(), 2u) << "nothing is forgotten";
    EXPECT_TRUE(is_replaced_try(history, 0));
    EXPECT_TRUE(is_replaced_try(history, 1));
}

TEST(Tries, LeaveOneAmongTheOtherStepsWhenSomethingElseFollowsThem)
{
    History history = box_moved_to({1, 2, 3});
    history.undo();
    history.run(Rename{1, "Brick"});
    ASSERT_EQ(history.branches().size(), 3u);
    EXPECT_TRUE(is_replaced_try(history, 0));
    EXPECT_TRUE(is_replaced_try(history, 1));
    EXPECT_FALSE(is_replaced_try(history, 2)) << "the last of them";
}

TEST(Tries, StayWhereMoreWasBuiltOnThem)
{
    History history = box_moved_to({1});
    history.run(AddSphere{});
    history.undo();
    history.undo();
    history.run(at(2));
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_FALSE(is_replaced_try(history, 0));
}

TEST(Tries, AreOfOneKindOnOneObjectWithOneStroke)
{
    EXPECT_TRUE(differ_in_numbers_only(at(1), at(2)));
    EXPECT_FALSE(differ_in_numbers_only(at(1), SetTransform{2, {}}));
    EXPECT_FALSE(differ_in_numbers_only(at(1), AddBox{}));
    EXPECT_FALSE(differ_in_numbers_only(Rename{1, "a"}, Rename{1, "b"})) << "names are no numbers";
    EXPECT_TRUE(differ_in_numbers_only(SetMaterial{{1}, {.roughness = 0.1f}},
                                       SetMaterial{{1}, {.roughness = 0.2f}}));
    EXPECT_FALSE(differ_in_numbers_only(SetMaterial{{1}, {}}, SetMaterial{{2}, {}}));
    Place drawn{1, {}, {}, {}}, again = drawn;
    again.parameters.width = 2;
    EXPECT_TRUE(differ_in_numbers_only(drawn, again));
    again.sketch.samples = {{{1, 2}, 0, 1}};
    EXPECT_FALSE(differ_in_numbers_only(drawn, again)) << "a stroke is a work of its own";
}

} // namespace
} // namespace trivar
