// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

struct Hand : Rig {
    Hand() { two_objects(); }
    std::string tool() { return editor.active_tool().name(); }
};

TEST(LentTool, GoesWithItsKeyWhenSomethingWasDoneWithIt)
{
    Hand hand;
    const std::size_t before = hand.steps();
    hand.move(hand.layout().view.center());
    hand.hold('D');
    EXPECT_EQ(hand.tool(), "Place");
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place");
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Select");
    EXPECT_EQ(hand.steps(), before + 1);
}

TEST(LentTool, FinishesWhatItDoesThoughItsKeyIsUp)
{
    Hand hand;
    hand.move(hand.layout().view.center());
    hand.hold('D');
    hand.draw(hand.stroke(), false);
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Place");
    EXPECT_TRUE(hand.editor.active_tool().busy());
    hand.screen.input().push(ui::press(ui::Button::left, false));
    hand.wait();
    EXPECT_EQ(hand.tool(), "Select");
}

TEST(LentTool, StaysWhenItsKeyIsOnlyTapped)
{
    Hand hand;
    hand.move(hand.layout().view.center());
    hand.hold('D');
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Place");
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place");
}

} // namespace
} // namespace trivar
