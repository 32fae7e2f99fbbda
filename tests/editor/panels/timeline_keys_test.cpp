// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/view.h"
#include "editor/actions/key_actions.h"
#include "editor/panels/timeline/curve_scale.h"
#include "editor/record/sequence.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;
const TrackName rising_track{1, "transform.translation.z"};
const TrackName sliding_track{1, "transform.translation.x"};

// A box with two tracks, the timeline open at its keys.
struct Keyed : Rig {
    Keyed() : Rig({1024, 700})
    {
        editor.preferences.timeline_open = true;
        editor.preferences.quality = "draft";
        editor.session.run(AddBox{});
        editor.session.run(Animate{{{1,
                                     {{rising_track.parameter, {{21, 0}, {61, 1}, {121, 0.5}}},
                                      {sliding_track.parameter, {{21, 0}, {121, 2}}}}}}});
        editor.session.selected = 1;
        view().unfolded.insert(1);
        wait();
    }
    KeysView& view() { return editor.timeline.keys; }
    FrameScale scale() const { return track_scale(screen.theme(), layout().timeline, editor); }
    // Rows: the box, then X and Z.
    glm::vec2 at(double frame, int row) const
    {
        const float top = layout().timeline.lo.y + 40 + 24;
        return {scale().x(frame), top + 24 * static_cast<float>(row) + 12};
    }
    std::vector<double> frames_of(const TrackName& name) const
    {
        std::vector<double> out;
        if (const Track* track = track_of(editor.session.document(), name))
            for (const Key& key : track->keys) out.push_back(key.frame);
        return out;
    }
    void pull(glm::vec2 from, int frames, bool let_go = true)
    {
        draw({from, from + glm::vec2(scale().x(1 + frames) - scale().x(1), 0)}, let_go);
        wait();
    }
};
using Frames = std::vector<double>;

TEST(TimelineKeys, AClickChoosesOneAndCtrlAddsAnother)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.click(rig.at(61, 2));
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 61}}));
    rig.hold(ui::key_left_control);
    rig.click(rig.at(121, 1));
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 61}, {sliding_track, 121}}));
    rig.click(rig.at(61, 2));
    rig.hold(ui::key_left_control, false);
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{sliding_track, 121}}));
    rig.click(rig.at(90, 2));
    EXPECT_TRUE(rig.view().chosen.empty());
    EXPECT_EQ(rig.steps(), steps);
}

TEST(TimelineKeys, BeyondTheScenesFramesAreMarkedInTheRulerAndReachedByTheWheel)
{
    Keyed rig;
    ASSERT_TRUE(rig.editor.session.run(SetTime{{41, 100, 24}}));
    rig.wait();
    EXPECT_EQ(rig.scale().first, 41);
    EXPECT_EQ(rig.scale().last, 100);
    const ui::Rect r = rig.layout().timeline;
    const float y = r.lo.y + 40 + 12;
    rig.click({r.hi.x - 14, y});
    EXPECT_EQ(rig.scale().last, 121);
    EXPECT_EQ(rig.editor.session.frame(), 41); // the ruler has not taken the click
    rig.click({names_end(rig.screen.theme(), r) + 14, y});
    EXPECT_EQ(rig.scale().first, 21);
    rig.move({rig.scale().x(60), y});
    rig.key({ui::key_home}); // the scene's frames again
    EXPECT_EQ(rig.scale().last, 100);
    rig.screen.input().push(ui::turn_wheel(-9));
    rig.frames(3);
    EXPECT_EQ(rig.scale().first, 21);
    EXPECT_EQ(rig.scale().last, 121);
}

TEST(TimelineKeys, ARowOfAnObjectHasTheKeysOfAllItsTracks)
{
    Keyed rig;
    rig.click(rig.at(121, 0));
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 121}, {sliding_track, 121}}));
    rig.view().unfolded.clear();
    rig.frames();
    rig.pull(rig.at(121, 0), 10);
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 131}));
    EXPECT_EQ(rig.frames_of(sliding_track), (Frames{21, 131}));
}

TEST(TimelineKeys, ADragMovesKeysInOneStepByWholeFrames)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.pull(rig.at(61, 2), 12);
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 73, 121}));
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 73}}));
    EXPECT_EQ(rig.steps(), steps + 1);
    rig.key({.key = 'Z', .ctrl = true});
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 121}));
}

TEST(TimelineKeys, ADragShowsWhatItDoesAndEscapeLeavesNoTrace)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.pull(rig.at(61, 2), 12, false);
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 73, 121}));
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 121}));
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_FALSE(rig.editor.session.proposing());
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 61}}));
}

TEST(TimelineKeys, ABoxChoosesWhatIsInIt)
{
    Keyed rig;
    rig.draw({rig.at(50, 1) - glm::vec2(0, 10), rig.at(130, 2) + glm::vec2(0, 10)});
    EXPECT_EQ(rig.view().chosen,
              (ChosenKeys{{rising_track, 61}, {rising_track, 121}, {sliding_track, 121}}));
}

TEST(TimelineKeys, AltDragLeavesCopies)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.hold(ui::key_left_alt);
    rig.pull(rig.at(61, 2), 20);
    rig.hold(ui::key_left_alt, false);
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 81, 121}));
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST(TimelineKeys, DeleteTakesThemAndNotTheObject)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.click(rig.at(61, 2));
    rig.key({ui::key_delete});
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 121}));
    EXPECT_TRUE(rig.editor.session.document().objects.contains(1));
    rig.key({'A'});
    EXPECT_EQ(rig.view().chosen.size(), 4u);
    rig.key({ui::key_delete});
    EXPECT_TRUE(animated_ids(rig.editor.session.document()).empty());
    EXPECT_EQ(rig.steps(), steps + 2);
}

TEST(TimelineKeys, SScalesAboutThePlayheadTillAClick)
{
    Keyed rig;
    const std::size_t steps = rig.steps();
    rig.editor.session.show_frame(21);
    rig.click(rig.at(61, 2));
    rig.key({'S'});
    rig.move(rig.at(101, 2));
    rig.click(rig.at(101, 2));
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    const Frames scaled = rig.frames_of(rising_track);
    ASSERT_EQ(scaled.size(), 3u);
    EXPECT_NEAR(scaled[1], 101, 1) << "a pixel is less than a frame";
    rig.key({'G'});
    rig.move(rig.at(91, 2));
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.frames_of(rising_track), scaled);
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST(TimelineKeys, CtrlDCopiesTheChosenOnesTillAClick)
{
    Keyed rig;
    rig.click(rig.at(61, 2));
    rig.key({.key = 'D', .ctrl = true});
    rig.move(rig.at(81, 2));
    rig.click(rig.at(81, 2));
    rig.wait();
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 81, 121}));
    EXPECT_EQ(rig.view().chosen, (ChosenKeys{{rising_track, 81}}));
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
}

TEST(TimelineKeys, UpAndDownGoFromKeyToKey)
{
    Keyed rig;
    rig.key({ui::key_up});
    EXPECT_EQ(rig.editor.session.frame(), 21);
    rig.key({ui::key_up});
    EXPECT_EQ(rig.editor.session.frame(), 61);
    rig.key({ui::key_down});
    EXPECT_EQ(rig.editor.session.frame(), 21);
    rig.key({ui::key_down});
    EXPECT_EQ(rig.editor.session.frame(), 21) << "there is none before";
}

TEST(TimelineKeys, NumbersOfTheChosenOneAreTyped)
{
    Keyed rig;
    rig.click(rig.at(61, 2));
    rig.frames();
    const ui::Rect bar = rig.layout().timeline;
    // The value is the last for which there is room here.
    const glm::vec2 value{bar.hi.x - 8 - 44, bar.lo.y + 20};
    const std::size_t steps = rig.steps();
    rig.click(value);
    rig.frames(4);
    rig.type("0.25");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(key_of(rig.editor.session.document(), {rising_track, 61})->value, 0.25);
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST(TimelineKeys, BearAnUndoWhileTheyAreChosen)
{
    Keyed rig;
    rig.click(rig.at(61, 2));
    rig.editor.session.undo(); // there are none at all any more
    rig.frames();
    rig.editor.session.redo();
    rig.frames();
    EXPECT_EQ(rig.frames_of(rising_track).size(), 3u);
}

struct Curved : Keyed {
    Curved()
    {
        view().curves = true;
        view().tracks = {rising_track};
        frames();
    }
    CurveScale curves() const
    {
        const ui::Rect r = layout().timeline;
        const float above = editor.timeline.keys.tracks.size() > 1 ? 36 : 18;
        CurveScale out{scale(), r.lo.y + 40 + 24 + above, r.hi.y - 14};
        out.values = editor.timeline.keys.values.value_or(
            values_of_curves(editor.session.document(), {rising_track}));
        return out;
    }
    const Key& key(double frame) const
    {
        return *key_of(editor.session.document(), {rising_track, frame});
    }
};

TEST(Curves, TheirTabLeavesTheTimelineAsHighAsItWas)
{
    Keyed rig;
    const ui::Rect before = rig.layout().timeline;
    for (float x = before.lo.x + 12; x < before.lo.x + 300 && !rig.view().curves; x += 12)
        rig.click({x, before.lo.y + 40 + 12});
    ASSERT_TRUE(rig.view().curves);
    EXPECT_EQ(rig.layout().timeline.lo.y, before.lo.y);
    EXPECT_EQ(rig.layout().timeline.hi.y, before.hi.y);
}

TEST(Curves, AKeyIsDraggedInFrameAndValue)
{
    Curved rig;
    const CurveScale scale = rig.curves();
    const std::size_t steps = rig.steps();
    rig.draw({scale.at(61, 1), scale.at(71, 0.5)});
    rig.wait();
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 71, 121}));
    EXPECT_NEAR(rig.key(71).value, 0.5, 0.02);
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST(Curves, SidewaysAValueStays)
{
    Curved rig;
    rig.draw({rig.curves().at(61, 1), rig.curves().at(81, 1)});
    rig.wait();
    EXPECT_EQ(rig.key(81).value, 1);
}

TEST(Curves, AHandleOfTheChosenKeyIsDragged)
{
    Curved rig;
    rig.click(rig.curves().at(61, 1));
    const std::size_t steps = rig.steps();
    const TweenCurve before =
        curve_between(*track_of(rig.editor.session.document(), rising_track), 1);
    const CurveScale scale = rig.curves();
    rig.draw({scale.at(before.p1.x, before.p1.y), scale.at(91, 0.2)});
    rig.wait();
    EXPECT_NEAR(rig.key(61).after.x, 30, 1.5);
    EXPECT_NEAR(rig.key(61).after.y, -0.8, 0.05);
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_EQ(rig.frames_of(rising_track), (Frames{21, 61, 121}));
}

TEST(Curves, OfDifferentUnitsFillTheHeightEachByItself)
{
    Curved rig;
    const TrackName turning{1, "transform.rotation_deg.z"};
    rig.editor.session.run(Animate{{{1, {{turning.parameter, {{21, 0}, {121, 90}}}}}}});
    rig.view().tracks = {rising_track, turning};
    rig.wait();
    CurveScale scale = rig.curves();
    scale.values = values_of_curves(rig.editor.session.document(), {turning});
    rig.view().chosen = {{rising_track, 61}, {turning, 121}};
    rig.draw({scale.at(121, 90), scale.at(121, 45)});
    rig.wait();
    EXPECT_NEAR(key_of(rig.editor.session.document(), {turning, 121})->value, 45, 2);
    EXPECT_NEAR(rig.key(61).value, 0.5, 0.02) << "as far as the other, as it is seen";
    EXPECT_TRUE(rig.view().was_alone);
    rig.view().tracks = {rising_track, sliding_track};
    rig.frames();
    EXPECT_FALSE(rig.view().was_alone) << "both are metres";
    rig.view().alone = true;
    rig.frames();
    EXPECT_TRUE(rig.view().was_alone);
}

TEST(Curves, AreZoomedByTheWheelAndFitAgain)
{
    Curved rig;
    const glm::dvec2 all = rig.curves().values;
    const glm::vec2 middle = rig.curves().at(61, 0.5);
    rig.move(middle);
    rig.screen.input().push(ui::turn_wheel(3));
    rig.frames(3);
    const CurveScale zoomed = rig.curves();
    EXPECT_LT(zoomed.values.y - zoomed.values.x, 0.6 * (all.y - all.x));
    EXPECT_NEAR(zoomed.value_at(middle.y), 0.5, 0.01);
    EXPECT_NEAR(zoomed.frames.frame_at(middle.x), 61, 0.5);
    action(rig.editor, "Frame all").run(rig.editor);
    EXPECT_EQ(rig.curves().values, all);
    EXPECT_EQ(rig.scale().first, 1);
}

TEST(Curves, AreMovedByTheMiddleButton)
{
    Curved rig;
    const glm::vec2 middle = rig.curves().at(61, 0.5);
    rig.move(middle);
    rig.screen.input().push(ui::press(ui::Button::middle));
    rig.frames(2);
    rig.screen.input().push(ui::move_to(middle + glm::vec2(0, 20)));
    rig.frames(2);
    rig.screen.input().push(ui::press(ui::Button::middle, false));
    rig.frames(2);
    EXPECT_NEAR(rig.curves().value_at(middle.y + 20), 0.5, 0.01);
}

} // namespace
} // namespace trivar
