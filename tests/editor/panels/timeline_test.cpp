// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline/timeline.h"

#include "editor/actions/time_actions.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

namespace trivar {
namespace {

using testing::Rig;

// A box that travels on a table, and the open timeline.
struct Travelling : Rig {
    Travelling() : Rig({1024, 700})
    {
        editor.preferences.timeline_open = true;
        editor.preferences.quality = "draft"; // what is measured are frames of the scene
        editor.session.replace_scene(testing::typical_scene());
        wait();
        editor.session.notices.clear();
        let({.speed = 0.1, .start_frame = 25});
    }
    void let(const Travel& travel)
    {
        ASSERT_TRUE(editor.session.run(SetTravel{{2}, travel}));
        wait();
    }
    const Travel& travel() const { return object(editor.session.document(), 2).travel; }
    FrameScale scale() const { return track_scale(screen.theme(), layout().timeline, editor); }
    // In the first row of the tracks, or in the ruler over it.
    glm::vec2 row_at(float x) const { return {x, layout().timeline.lo.y + 40 + 24 + 12}; }
    glm::vec2 ruler_at(double frame) const
    {
        return {scale().x(frame), layout().timeline.lo.y + 40 + 12};
    }
    TravelBar bar() const { return bar_of(editor.session, 2).value(); }
    // Takes the bar there and goes so many frames to the right.
    void pull(float x, int frames, bool let_go = true)
    {
        const float by = scale().x(1 + frames) - scale().x(1);
        draw({row_at(x), row_at(x + by)}, let_go);
        wait();
    }
};

TEST(Timeline, StepsThroughTheFramesByKeysAndStaysInTheirRange)
{
    Travelling rig;
    const auto frame = [&] { return rig.editor.session.frame(); };
    EXPECT_EQ(frame(), 1);
    rig.key({ui::key_left});
    EXPECT_EQ(frame(), 1);
    rig.key({ui::key_right});
    EXPECT_EQ(frame(), 2);
    rig.key({.key = ui::key_right, .shift = true});
    EXPECT_EQ(frame(), 240);
    rig.key({ui::key_right});
    EXPECT_EQ(frame(), 240);
    ASSERT_TRUE(rig.editor.session.run(SetTime{{1, 100, 24}}));
    EXPECT_EQ(frame(), 100);
    rig.key({.key = ui::key_left, .shift = true});
    EXPECT_EQ(frame(), 1);
    rig.key({.key = 'T', .shift = true});
    EXPECT_FALSE(rig.editor.preferences.timeline_open);
}

TEST(Timeline, GoesOnThroughTheFramesWhileAnArrowIsHeld)
{
    Travelling rig;
    rig.hold(ui::key_right);
    rig.frames(60);
    rig.hold(ui::key_right, false);
    EXPECT_GT(rig.editor.session.frame(), 6);
}

TEST(Timeline, IsZoomedByTheWheelAboutTheFrameUnderTheMouseAndFitByHome)
{
    Travelling rig;
    const FrameScale all = rig.scale();
    const glm::vec2 at = rig.ruler_at(60);
    rig.move(at);
    rig.screen.input().push(ui::turn_wheel(3));
    rig.frames(3);
    const FrameScale zoomed = rig.scale();
    EXPECT_LT(zoomed.last - zoomed.first, 0.6 * (all.last - all.first));
    EXPECT_NEAR(zoomed.frame_at(at.x), 60, 0.5);
    rig.draw({at, at + glm::vec2(1, 0)}); // it scrubs as before
    EXPECT_EQ(rig.editor.session.frame(), 60);
    rig.move(rig.row_at(at.x));
    rig.screen.input().push(ui::turn_wheel(2)); // the rows' own
    rig.frames(3);
    EXPECT_EQ(rig.scale().first, zoomed.first);
    const ui::Rect view = rig.layout().view;
    const Camera camera = rig.editor.session.view.camera;
    rig.key({ui::key_home});
    EXPECT_EQ(rig.scale().last, all.last);
    EXPECT_EQ(rig.editor.session.view.camera.eye, camera.eye);
    rig.move(view.center());
    rig.key({ui::key_home});
    EXPECT_NE(rig.editor.session.view.camera.eye, camera.eye);
}

TEST(Timeline, ShowsTenFramesAtLeastAndNoneBeyondTheEnds)
{
    const glm::dvec2 all(1, 240);
    EXPECT_EQ(zoomed_frames(all, all, 60, -5), all);
    const glm::dvec2 close = zoomed_frames(all, all, 1, 100);
    EXPECT_EQ(close, glm::dvec2(1, 11));
    EXPECT_EQ(rolled_frames(close, all, 100), close);
    EXPECT_EQ(zoomed_frames(close, all, 50, 0), close); // over the margin beside them
    EXPECT_EQ(rolled_frames(close, all, -1000), glm::dvec2(230, 240));
    EXPECT_EQ(zoomed_frames({5, 5}, {5, 5}, 5, 3), glm::dvec2(5));
}

TEST(Timeline, LeavesTheArrowsToTheListThatHasTheKeyboard)
{
    Travelling rig;
    rig.click(rig.layout().outliner.lo + glm::vec2(60, 84)); // its first row
    ASSERT_EQ(rig.editor.panel, Editor::Panel::outliner);
    rig.key({ui::key_right});
    EXPECT_EQ(rig.editor.session.frame(), 1);
}

TEST(Timeline, PlaysByTheClockAndCostsNothingPaused)
{
    Travelling rig;
    const auto still = rig.editor.session.evaluated().objects.at(2);
    rig.key({ui::key_space});
    ASSERT_TRUE(rig.editor.playback.playing());
    const int before = rig.editor.session.frame();
    rig.frames(120); // of 1/60 s
    EXPECT_NEAR(rig.editor.session.frame(), before + 48, 1);
    rig.key({ui::key_space});
    EXPECT_FALSE(rig.editor.playback.playing());
    rig.wait();
    EXPECT_NE(rig.editor.session.evaluated().objects.at(2), still);
    EXPECT_LT(rig.screen.settle(rig.body(), 400), 400);
}

TEST(Timeline, BeginsAgainOrStopsAtTheLastFrame)
{
    Travelling rig;
    ASSERT_TRUE(rig.editor.session.run(SetTime{{1, 10, 24}}));
    rig.editor.playback.play(rig.editor.session);
    rig.frames(120);
    EXPECT_TRUE(rig.editor.playback.playing());
    rig.editor.preferences.loop = false;
    rig.frames(60);
    EXPECT_FALSE(rig.editor.playback.playing());
    EXPECT_EQ(rig.editor.session.frame(), 10);
    rig.key({ui::key_space});
    EXPECT_LT(rig.editor.session.frame(), 10); // from the first one
}

TEST(Timeline, ShowsTheFrameUnderTheMouseThatDragsInItsRuler)
{
    Travelling rig;
    const std::size_t steps = rig.steps();
    rig.draw({rig.ruler_at(30), rig.ruler_at(120)});
    rig.wait();
    EXPECT_EQ(rig.editor.session.frame(), 120);
    rig.draw({rig.ruler_at(120), rig.ruler_at(1) - glm::vec2(90, 0)});
    EXPECT_EQ(rig.editor.session.frame(), 1);
    rig.editor.preferences.timeline_open = false;
    rig.frames();
    const glm::vec2 middle{rig.layout().timeline.hi.x - 60, rig.layout().timeline.center().y};
    rig.click(middle);
    EXPECT_GT(rig.editor.session.frame(), 1);
    EXPECT_EQ(rig.steps(), steps);
}

TEST(Timeline, ABarThatIsDraggedSetsOutLaterInOneStep)
{
    Travelling rig;
    const std::size_t steps = rig.steps();
    const TravelBar before = rig.bar();
    rig.editor.session.selected = 1;
    rig.pull(rig.scale().x((before.begin + before.end) / 2), 20);
    EXPECT_EQ(rig.travel().start_frame, 45);
    EXPECT_EQ(rig.travel().speed, 0.1);
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_EQ(rig.editor.session.selected, 2);
}

TEST(Timeline, AnEndThatIsDraggedMakesItSlowerAndLeavesTheOtherEnd)
{
    Travelling rig;
    rig.let({.speed = 0.2, .start_frame = 25});
    const std::size_t steps = rig.steps();
    TravelBar before = rig.bar();
    rig.pull(rig.scale().x(before.end) - 2, 30);
    EXPECT_NEAR(rig.bar().end, before.end + 30, 1e-6);
    EXPECT_EQ(rig.bar().begin, before.begin);
    EXPECT_LT(rig.travel().speed, 0.2);
    before = rig.bar();
    rig.pull(rig.scale().x(before.begin) + 2, -10);
    EXPECT_NEAR(rig.bar().begin, before.begin - 10, 1) << "a mouse stands on whole pixels";
    EXPECT_NEAR(rig.bar().end, before.end, 1e-6);
    EXPECT_EQ(rig.steps(), steps + 2);
}

TEST(Timeline, TheEndOfWhatGoesOnForeverIsMadeByPullingIt)
{
    Travelling rig;
    rig.let({.speed = 0.1, .ends = Ends::back_and_forth, .start_frame = 25});
    EXPECT_TRUE(rig.bar().endless);
    rig.pull(rig.scale().x(25) + 2, 24);
    EXPECT_EQ(rig.travel().duration, 0);
    rig.pull(rig.scale().x(240), -48);
    EXPECT_FALSE(rig.bar().endless);
    EXPECT_NEAR(rig.bar().end, 241 - 48, 1);
    EXPECT_EQ(rig.travel().speed, 0.1);
}

TEST(Timeline, EscapeDuringADragLeavesNoTrace)
{
    Travelling rig;
    const std::size_t steps = rig.steps();
    const Travel before = rig.travel();
    rig.pull(rig.scale().x(rig.bar().begin + 5), 20, false);
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.travel(), before);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.travel(), before);
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_FALSE(rig.editor.session.proposing());
}

TEST(Timeline, AClickOnABarOnlySelectsAndALockedOneStays)
{
    Travelling rig;
    rig.editor.session.selected = 1;
    const std::size_t steps = rig.steps();
    rig.click(rig.row_at(rig.scale().x(rig.bar().begin + 5)));
    EXPECT_EQ(rig.editor.session.selected, 2);
    EXPECT_EQ(rig.steps(), steps);
    ASSERT_TRUE(rig.editor.session.run(Lock{{2}}));
    rig.pull(rig.scale().x(rig.bar().begin + 5), 20);
    EXPECT_EQ(rig.travel().start_frame, 25);
}

TEST(Timeline, MakesRoomForWhatIsStillOnItsWayInTheLastFrame)
{
    Travelling rig;
    const Action& make_room = action(rig.editor, make_room_action);
    rig.let({.speed = 1, .start_frame = 25});
    ASSERT_LT(rig.bar().end, 240);
    EXPECT_FALSE(is_enabled(rig.editor, make_room));
    rig.let({.speed = 0.002, .start_frame = 25});
    ASSERT_GT(rig.bar().end, 240);
    const std::size_t before = rig.steps();
    const ui::Rect r = rig.layout().timeline;
    rig.click({names_end(rig.screen.theme(), r) - 30, r.lo.y + 40 + 12});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    const Time& time = rig.editor.session.document().time;
    EXPECT_GT(time.last_frame, rig.bar().end);
    EXPECT_EQ(time.last_frame % 24, 0) << "whole seconds";
    EXPECT_LE(time.last_frame, rig.bar().end + 24);
    EXPECT_FALSE(is_enabled(rig.editor, make_room));
    rig.let({.speed = 0.002, .ends = Ends::loop, .start_frame = 25});
    EXPECT_FALSE(is_enabled(rig.editor, make_room)) << "it never ends";
}

TEST(Timeline, OpensAndClosesByItsUpperLine)
{
    Travelling rig;
    rig.editor.preferences.timeline_open = false;
    rig.frames();
    const auto drag = [&](float up) {
        const glm::vec2 line{300, rig.layout().timeline.lo.y};
        rig.draw({line, line - glm::vec2(0, up)});
    };
    drag(160);
    EXPECT_TRUE(rig.editor.preferences.timeline_open);
    EXPECT_NEAR(rig.layout().timeline.height(), 200, 3);
    drag(900);
    EXPECT_GE(rig.layout().view.height(), 150) << "the picture keeps its room";
    drag(-600);
    EXPECT_FALSE(rig.editor.preferences.timeline_open);
    EXPECT_EQ(rig.layout().timeline.height(), 40);
}

TEST(Playing, SpaceMayTurnTheViewAndThenPlaysWhereItIsOnlyTapped)
{
    Rig rig;
    rig.two_objects();
    rig.editor.preferences.mouse.emulation = "space";
    rig.frames();
    const auto eye = [&] { return rig.editor.session.view.camera.eye; };
    const glm::dvec3 before = eye();
    const glm::vec2 c = rig.layout().view.center();
    rig.hold(ui::key_space);
    rig.draw({c, c + glm::vec2(50, 0)});
    rig.hold(ui::key_space, false);
    EXPECT_NE(eye(), before);
    EXPECT_FALSE(rig.editor.playback.playing());
    rig.hold(ui::key_space);
    EXPECT_FALSE(rig.editor.playback.playing());
    rig.hold(ui::key_space, false);
    EXPECT_TRUE(rig.editor.playback.playing());
}

} // namespace
} // namespace trivar
