// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/selection.h"

#include "core/commands/command.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig;

TEST(Selection, ReadsAsItsActiveObjectWhichIsTheLastOneChosen)
{
    Selection s;
    EXPECT_EQ(s, 0);
    s = 3;
    s.add({5, 3, 0, 4});
    EXPECT_THAT(s.ids(), ElementsAre(5, 3, 4));
    EXPECT_EQ(s, 4);
    s.toggle(4);
    EXPECT_EQ(s, 3);
    s.toggle(9);
    EXPECT_THAT(s.ids(), ElementsAre(5, 3, 9));
    s = 0;
    EXPECT_THAT(s.ids(), IsEmpty());
}

TEST(Selection, OfAGroupAndAMemberIsTheGroupWhereBothWouldBeMoved)
{
    Document d;
    for (const Command& c : {Command(AddBox{}), Command(AddBox{}), Command(Group{{2}})})
        d = after(d, c);
    EXPECT_THAT(topmost(d, {2, 1, 3}), ElementsAre(1, 3));
    EXPECT_TRUE(Members(d, {3}).contain(2));
    EXPECT_FALSE(Members(d, {3}).contain(1));
    EXPECT_FALSE(Members(d, {3}).contain(9)) << "there is no such object";
    EXPECT_THAT(topmost(d, {9, 1}), ElementsAre(1));
}

// Three boxes in a row on nothing, seen from the front.
struct Row : Rig {
    Row()
    {
        for (int i = 0; i < 3; ++i) {
            AddBox box;
            box.transform.translation = {2 * i - 2, 0, 0};
            editor.session.run(box);
        }
        editor.session.view.camera.eye = {0, -12, 2};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    const std::vector<Id>& ids() const { return editor.session.selected.ids(); }
    glm::vec2 box(int i) const { return seen_at({2 * i - 2, -0.5, 0}); }
    glm::vec2 row(int i) const { return layout().outliner.lo + glm::vec2(80, 72 + 24 * i + 12); }
};

TEST(SelectingByHand, AClickSelectsAndShiftOrCtrlAddsOrRemoves)
{
    for (const int key : {ui::key_left_shift, ui::key_left_control}) {
        Row rig;
        const glm::vec2 beside = rig.layout().view.lo + glm::vec2(20, 300);
        rig.click(rig.box(0));
        EXPECT_THAT(rig.ids(), ElementsAre(1));
        rig.hold(key);
        rig.click(rig.box(2));
        EXPECT_THAT(rig.ids(), ElementsAre(1, 3));
        rig.click(rig.box(0));
        EXPECT_THAT(rig.ids(), ElementsAre(3));
        rig.click(beside);
        EXPECT_THAT(rig.ids(), ElementsAre(3));
        rig.hold(key, false);
        rig.click(beside);
        EXPECT_THAT(rig.ids(), IsEmpty());
    }
}

TEST(SelectingByHand, ShiftAddsWithTheToolsThatMoveToo)
{
    Row rig;
    rig.editor.choose_tool(1); // Move
    rig.click(rig.box(0));
    rig.hold(ui::key_left_shift);
    rig.click(rig.box(2));
    rig.hold(ui::key_left_shift, false);
    EXPECT_THAT(rig.ids(), ElementsAre(1, 3));
}

TEST(SelectingByHand, ABoxWithShiftAdds)
{
    Row rig;
    rig.editor.session.selected = 3;
    rig.hold(ui::key_left_shift);
    rig.draw({rig.box(0) - glm::vec2(0, 100), rig.box(1) + glm::vec2(0, 60)});
    rig.hold(ui::key_left_shift, false);
    EXPECT_THAT(rig.ids(), ElementsAre(3, 1, 2));
}

TEST(SelectingByHand, ADragOnNothingSelectsWhatIsSeenInTheBox)
{
    Row rig;
    const glm::vec2 a = rig.box(0) - glm::vec2(0, 100), b = rig.box(1) + glm::vec2(0, 60);
    rig.draw({a, b});
    EXPECT_THAT(rig.ids(), ElementsAre(1, 2));
    rig.draw({rig.box(2) - glm::vec2(10, 100), rig.box(2) + glm::vec2(10, 60)}, false);
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames();
    EXPECT_THAT(rig.ids(), ElementsAre(1, 2)) << "Escape leaves the selection as it was";
}

TEST(SelectingByHand, BBeginsTheBoxEvenOnAnObject)
{
    Row rig;
    rig.key({'B'});
    rig.draw({rig.box(1), rig.box(2)});
    EXPECT_THAT(rig.ids(), ElementsAre(2, 3));
}

TEST(SelectingByHand, KeysTakeAllNoneAndTheOthers)
{
    Row rig;
    rig.editor.session.selected = 2;
    rig.key({.key = 'I', .ctrl = true});
    EXPECT_THAT(rig.ids(), ElementsAre(1, 3));
    rig.key({'A'});
    EXPECT_EQ(rig.ids().size(), 3u);
    EXPECT_EQ(rig.editor.session.selected, 3) << "the active one stays";
    rig.key({.key = 'A', .alt = true});
    EXPECT_THAT(rig.ids(), IsEmpty());
}

TEST(SelectingByHand, TheOutlinerAddsWithCtrlAndRangesWithShift)
{
    Row rig;
    rig.click(rig.row(2));
    EXPECT_THAT(rig.ids(), ElementsAre(3));
    rig.hold(ui::key_left_shift);
    rig.click(rig.row(0));
    rig.hold(ui::key_left_shift, false);
    EXPECT_THAT(rig.ids(), ElementsAre(1, 2, 3));
    rig.hold(ui::key_left_control);
    rig.click(rig.row(1));
    rig.hold(ui::key_left_control, false);
    EXPECT_THAT(rig.ids(), ElementsAre(1, 3));
}

TEST(SelectingByHand, WhatIsDoneToSeveralIsOneStep)
{
    Row rig;
    rig.editor.session.selected.set({1, 3});
    rig.key({.key = 'D', .shift = true});
    EXPECT_EQ(rig.steps(), 4u);
    EXPECT_THAT(rig.ids(), ElementsAre(4, 5));
    rig.key({ui::key_escape}); // they would follow the mouse
    EXPECT_EQ(rig.steps(), 4u);
    rig.key({'H'});
    EXPECT_TRUE(object(rig.editor.session.document(), 4).hidden);
    EXPECT_TRUE(object(rig.editor.session.document(), 5).hidden);
    rig.key({.key = 'H', .alt = true});
    EXPECT_FALSE(object(rig.editor.session.document(), 4).hidden);
    rig.key({ui::key_delete});
    EXPECT_EQ(rig.editor.session.document().objects.size(), 3u);
    EXPECT_EQ(rig.steps(), 7u);
    rig.editor.session.undo();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 5u);
}

} // namespace
} // namespace trivar
