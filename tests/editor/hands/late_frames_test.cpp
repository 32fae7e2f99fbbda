// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that come late: what hands did meanwhile comes at once.
#include "tests/editor/laid.h"

namespace trivar {
namespace {

using testing::LaidRig, testing::Rig;

// Nobody has seen the mouse over the picture before: it rests on a row of the outliner.
struct LateRig : Rig {
    LateRig()
    {
        two_objects();
        editor.preferences.hints = false; // their cards take clicks
        key({'D'});
        move(layout().outliner.center());
        wait();
    }
    // All of it in one frame, with the times at which it happened.
    void at_once(const std::vector<glm::vec2>& path, bool let_go = true)
    {
        ui::Input& input = screen.input();
        double time_s = 100;
        input.push(ui::move_to(path.front(), time_s));
        input.push(ui::press(ui::Button::left, true, time_s));
        for (std::size_t i = 1; i < path.size(); ++i)
            for (int k = 1; k <= 8; ++k)
                input.push(ui::move_to(glm::mix(path[i - 1], path[i], static_cast<float>(k) / 8),
                                       time_s += 0.01));
        if (let_go) input.push(ui::press(ui::Button::left, false, time_s));
        frames(1);
    }
};

TEST(LateFrames, KeepTheStrokeThatWasDrawnMeanwhile)
{
    LateRig rig;
    const std::vector<glm::vec2> path = rig.stroke();
    rig.at_once(path);
    rig.frames(8);
    rig.wait();
    const auto& step = object(rig.editor.session.committed(), 2).stroke;
    ASSERT_TRUE(step);
    const std::vector<StrokeSample>& samples = step->sketch.samples;
    EXPECT_EQ(glm::vec2(samples.front().p_px) + rig.layout().view.lo, path.front());
    EXPECT_EQ(glm::vec2(samples.back().p_px) + rig.layout().view.lo, path.back());
    EXPECT_EQ(samples.front().time_s, 0);
    EXPECT_NEAR(samples.back().time_s, 0.16, 1e-9) << "as long as the hand took";
    EXPECT_EQ(samples.size(), 17u) << "no piece of the way is lost";
}

TEST(LateFrames, KeepAPressThatComesWithTheMove)
{
    LateRig rig;
    rig.at_once({rig.stroke().front()}, false);
    rig.frames(3);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    rig.key({ui::key_escape});
}

TEST(LateFrames, KeepAStrokeThatBeginsWhileTheLastOneIsBeingLaid)
{
    LateRig rig;
    std::vector<glm::vec2> path = rig.stroke();
    rig.at_once(path);
    for (glm::vec2& p : path) p.y += 25;
    rig.at_once(path);
    rig.frames(12);
    rig.wait();
    rig.frames(8);
    rig.wait();
    const auto& step = object(rig.editor.session.committed(), 2).stroke;
    ASSERT_TRUE(step);
    EXPECT_EQ(rig.steps(), 4u);
    EXPECT_EQ(glm::vec2(step->sketch.samples.front().p_px) + rig.layout().view.lo, path.front());
}

TEST(LateFrames, UndoTakesBackTheStrokeThatIsStillBeingLaid)
{
    LateRig rig;
    rig.at_once(rig.stroke());
    rig.screen.input().push(ui::press_key(ui::key_left_control));
    rig.screen.input().push(ui::press_key('Z'));
    rig.screen.input().push(ui::press_key('Z', false));
    rig.screen.input().push(ui::press_key(ui::key_left_control, false));
    rig.frames(12);
    rig.wait();
    rig.frames(8);
    EXPECT_EQ(rig.steps(), 2u) << "and not the step before it";
    EXPECT_FALSE(object(rig.editor.session.committed(), 2).stroke);
}

TEST(LateFrames, KeepAClickOnWhatWasUnderIt)
{
    LateRig rig;
    rig.key({'Q'});
    rig.editor.session.selected = 1;
    rig.move(rig.layout().outliner.center());
    ui::Input& input = rig.screen.input();
    input.push(ui::move_to(rig.seen_at({0, 0, 1})));
    input.push(ui::press(ui::Button::left));
    input.push(ui::press(ui::Button::left, false));
    rig.frames(6);
    EXPECT_EQ(rig.editor.session.selected, 2);
}

} // namespace
} // namespace trivar
