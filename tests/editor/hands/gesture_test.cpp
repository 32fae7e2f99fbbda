// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gesture.h"

#include "core/commands/objects/primitives.h"
#include "editor/hands/viewport_input.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

// A hand whose gesture adds a ball as large as it is dragged, which is nothing at first.
struct GestureRig : testing::Rig {
    Gesture gesture;
    ViewportInput hand;
    Gesture::State go_on()
    {
        const Gesture::State state = gesture.go_on(editor.session, hand, [&] { return wanted(); });
        wait();
        return state;
    }
    std::optional<Command> wanted() const
    {
        const double radius = glm::distance(hand.mouse, gesture.from_px()) / 100;
        if (radius == 0) return {};
        return AddSphere{.shape = {.radius = radius}};
    }
    void press(bool by_key = false)
    {
        hand.down = !by_key;
        gesture.begin(hand, by_key);
    }
    std::size_t balls() const { return editor.session.document().objects.size(); }
};

TEST(Gesture, ShowsItsResultAndIsOneStepWhereTheButtonIsLetGo)
{
    GestureRig rig;
    rig.press();
    EXPECT_EQ(rig.go_on(), Gesture::State::goes_on);
    EXPECT_FALSE(rig.editor.session.proposing());
    for (const double x : {20, 40, 60}) {
        rig.hand.mouse.x = x;
        EXPECT_EQ(rig.go_on(), Gesture::State::goes_on);
        EXPECT_EQ(rig.balls(), 1u);
        EXPECT_EQ(rig.steps(), 0u);
    }
    rig.hand.released = true;
    EXPECT_EQ(rig.go_on(), Gesture::State::done);
    EXPECT_FALSE(rig.gesture);
    EXPECT_EQ(rig.steps(), 1u);
}

TEST(Gesture, LeavesNoTraceWhereItIsCancelled)
{
    GestureRig rig;
    rig.press();
    rig.hand.mouse.x = 50;
    rig.go_on();
    rig.gesture.cancel(rig.editor.session);
    EXPECT_FALSE(rig.gesture);
    EXPECT_EQ(rig.balls(), 0u);
    rig.hand.released = true;
    EXPECT_EQ(rig.go_on(), Gesture::State::dropped);
    EXPECT_EQ(rig.steps(), 0u);
}

TEST(Gesture, TakesBackWhatItShowedWhereNothingIsWantedAnyMore)
{
    GestureRig rig;
    rig.press();
    rig.hand.mouse.x = 50;
    rig.go_on();
    rig.hand.mouse.x = 0;
    EXPECT_EQ(rig.go_on(), Gesture::State::goes_on);
    EXPECT_EQ(rig.balls(), 0u);
    rig.hand.released = true;
    EXPECT_EQ(rig.go_on(), Gesture::State::dropped);
    EXPECT_TRUE(rig.gesture.moved());
    EXPECT_EQ(rig.steps(), 0u);
}

TEST(Gesture, ThatAKeyBeganGoesOnUntilAClick)
{
    GestureRig rig;
    rig.press(true);
    rig.hand.mouse.x = 50;
    EXPECT_EQ(rig.go_on(), Gesture::State::goes_on);
    rig.hand.pressed = true;
    EXPECT_EQ(rig.go_on(), Gesture::State::done);
    EXPECT_EQ(rig.steps(), 1u);
}

TEST(Gesture, CommitsAsItIsTold)
{
    GestureRig rig;
    rig.press();
    rig.hand.mouse.x = 50;
    int times = 0;
    rig.gesture.finish(
        rig.editor.session, [&] { return rig.wanted(); }, [&] { ++times; });
    EXPECT_EQ(times, 1);
    EXPECT_EQ(rig.steps(), 0u);
    rig.editor.session.cancel();
}

} // namespace
} // namespace trivar
