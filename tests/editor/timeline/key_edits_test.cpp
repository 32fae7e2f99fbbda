// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/paste.h"
#include "editor/timeline/key_edits.h"

#include "core/commands/words/number_words.h"
#include "editor/timeline/rows.h"
#include "tests/editor/scenes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

const TrackName upward_track{1, "transform.translation.z"};
const TrackName shine_track{2, "material.metallic"};

Document with_keys()
{
    Document document = after(after({}, AddBox{}), AddBox{});
    document = after(document, SetMaterial{{2}, Surfacing{}});
    return after(document, Animate{{{1, {{upward_track.parameter, {{1, 0}, {11, 1}, {21, 0}}}}},
                                    {2, {{shine_track.parameter, {{1, 0}, {11, 0.5}}}}}}});
}

Document done(const Document& document, const KeyEdit& edit)
{
    return edit.command ? after(document, *edit.command) : document;
}

TEST(KeyEdits, MoveKeysOfSeveralTracksAndTellWhereTheyAre)
{
    const Document before = with_keys();
    const KeyEdit edit = moved(before, {{upward_track, 11}, {shine_track, 11}}, 4);
    EXPECT_EQ(edit.keys, (ChosenKeys{{upward_track, 15}, {shine_track, 15}}));
    const Document now = done(before, edit);
    EXPECT_EQ(key_of(now, {upward_track, 15})->value, 1);
    EXPECT_EQ(key_of(now, {shine_track, 15})->value, 0.5);
    EXPECT_FALSE(key_of(now, {upward_track, 11}));
    EXPECT_EQ(track_of(now, upward_track)->keys.size(), 3u);
    EXPECT_FALSE(moved(before, {{upward_track, 11}}, 0).command);
}

TEST(KeyEdits, AKeyThatIsMovedOntoAnotherTakesItsPlace)
{
    const Document before = with_keys(),
                   now = done(before, moved(before, {{upward_track, 11}}, 10));
    ASSERT_EQ(track_of(now, upward_track)->keys.size(), 2u);
    EXPECT_EQ(key_of(now, {upward_track, 21})->value, 1);
}

TEST(KeyEdits, KeysPassOneAnotherAndKeepTheirOrder)
{
    const Document before = with_keys(), now = done(before, moved(before, {{upward_track, 1}}, 15));
    ASSERT_EQ(track_of(now, upward_track)->keys.size(), 3u);
    EXPECT_EQ(track_of(now, upward_track)->keys[1].frame, 16);
}

TEST(KeyEdits, ValuesStayInTheirRange)
{
    const Document before = with_keys();
    EXPECT_EQ(key_of(done(before, moved(before, {{shine_track, 11}}, 0,
                                        [](const TrackName&) { return 7.0; })),
                     {shine_track, 11})
                  ->value,
              1);
    EXPECT_EQ(
        key_of(done(before, with_value(before, {{shine_track, 11}}, -3)), {shine_track, 11})->value,
        0);
}

TEST(KeyEdits, CopiesLeaveWhatTheyAreCopiesOf)
{
    const Document before = with_keys();
    const KeyEdit edit = copied(before, {{upward_track, 1}, {upward_track, 11}}, 30);
    const Document now = done(before, edit);
    EXPECT_EQ(track_of(now, upward_track)->keys.size(), 5u);
    EXPECT_EQ(key_of(now, {upward_track, 41})->value, 1);
    EXPECT_EQ(edit.keys, (ChosenKeys{{upward_track, 31}, {upward_track, 41}}));
}

TEST(KeyEdits, ScaleTimeAboutAFrameToWholeFrames)
{
    const Document before = with_keys();
    EXPECT_EQ(scaled(before, {{upward_track, 11}, {upward_track, 21}}, 1, 1.55).keys,
              (ChosenKeys{{upward_track, 17}, {upward_track, 32}}));
    EXPECT_EQ(scaled(before, {{upward_track, 21}}, 11, -1).keys, (ChosenKeys{{upward_track, 1}}));
}

TEST(KeyEdits, ThatTurnKeysRoundKeepTheWayOfEachPiece)
{
    Document before = with_keys();
    before = done(before, with_tween(before, {{upward_track, 1}}, Tween::step));
    before = done(before, with_tween(before, {{upward_track, 11}}, Tween::linear));
    const ChosenKeys all{{upward_track, 1}, {upward_track, 11}, {upward_track, 21}};
    const Document now = done(before, scaled(before, all, 11, -1));
    EXPECT_EQ(key_of(now, {upward_track, 1})->tween, Tween::linear);
    EXPECT_EQ(key_of(now, {upward_track, 11})->tween, Tween::step);
    EXPECT_EQ(key_of(now, {upward_track, 21})->tween, Tween::cubic);
}

TEST(KeyEdits, ATrackWithoutKeysIsGone)
{
    const Document before = with_keys();
    const KeyEdit edit = without(
        before, {{upward_track, 1}, {upward_track, 11}, {upward_track, 21}, {shine_track, 1}});
    const Document now = done(before, edit);
    EXPECT_FALSE(track_of(now, upward_track));
    EXPECT_EQ(track_of(now, shine_track)->keys.size(), 1u);
    EXPECT_TRUE(edit.keys.empty());
}

TEST(KeyEdits, SetTheWayToTheNextKeyAndWhatComesAfterTheLast)
{
    const Document before = with_keys();
    Document now = done(before, with_tween(before, {{upward_track, 1}}, Tween::step));
    EXPECT_EQ(value_at(*track_of(now, upward_track), 10), 0);
    now = done(now, with_repeat(now, {{upward_track, 1}}, Repeat::loop));
    EXPECT_EQ(track_of(now, upward_track)->repeat, Repeat::loop);
}

TEST(KeyEdits, AHandleTurnsTheOneOppositeUnlessItIsAlone)
{
    const Document before = with_keys();
    const Document both =
        done(before, with_handle(before, {upward_track, 11}, KeyHandle::after, {14, 2.5}, false));
    const Key& key = *key_of(both, {upward_track, 11});
    EXPECT_EQ(key.after, glm::dvec2(3, 1.5));
    EXPECT_LT(key.before.x, 0);
    EXPECT_NEAR(key.before.y / key.before.x, 0.5, 1e-12);
    const Document one =
        done(before, with_handle(before, {upward_track, 11}, KeyHandle::after, {14, 2.5}, true));
    EXPECT_EQ(key_of(one, {upward_track, 11})->before.y, 0) << "level, as it was";
    const Document far =
        done(before, with_handle(before, {upward_track, 11}, KeyHandle::after, {99, 2}, false));
    EXPECT_EQ(key_of(far, {upward_track, 11})->after.x, 10) << "no further than the next key";
    EXPECT_EQ(key_of(done(both, smoothed(both, {{upward_track, 11}})), {upward_track, 11})->after,
              glm::dvec2(0));
}

TEST(KeyEdits, TracksOfWhatIsNotThereAnyMoreStayAndCanGo)
{
    Document document = with_keys();
    document = after(document, ClearMaterial{{2}});
    EXPECT_FALSE(numbers_of(document, timeline_rows(document, {1, 2})).contains(shine_track));
    const KeyEdit edit = moved(document, {{shine_track, 1}, {upward_track, 1}}, 2);
    ASSERT_TRUE(edit.command);
    const Document now = after(document, *edit.command);
    EXPECT_TRUE(key_of(now, {shine_track, 1}));
    EXPECT_TRUE(key_of(now, {upward_track, 3}));
    const KeyEdit gone = without(document, {{shine_track, 1}, {shine_track, 11}});
    ASSERT_TRUE(gone.command);
    EXPECT_FALSE(track_of(after(document, *gone.command), shine_track));
}

TEST(TimelineRows, AreOneAnObjectAndOneATrackWhereItIsUnfolded)
{
    const Document document = after(with_keys(), Animate{{{0, {{"render.exposure", {{1, 0}}}}}}});
    EXPECT_EQ(timeline_rows(document, {}).size(), 3u);
    const std::vector<TimelineRow> rows = timeline_rows(document, {1});
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(name_of_row(document, rows[0]), "Scene");
    EXPECT_EQ(name_of_row(document, rows[2]), "Position Z");
    EXPECT_EQ(keys_of_row(document, rows[1]).size(), 3u);
    EXPECT_EQ(key_frames(document, {1, 2}), (std::set<double>{1, 11, 21}));
}

TEST(TimelineRows, ShowATravelThatHasKeysAlsoWhileItsRowIsFolded)
{
    const Document document = after(testing::typical_scene().document(),
                                    Animate{{{2, {{"placement.width", {{1, 0.2}}}}}}});
    const std::vector<TimelineRow> folded = timeline_rows(document, {});
    ASSERT_EQ(folded.size(), 1u);
    EXPECT_TRUE(folded[0].travels);
    const std::vector<TimelineRow> open = timeline_rows(document, {2});
    ASSERT_EQ(open.size(), 3u); // the object, its travel and the track
    EXPECT_FALSE(open[0].travels);
    EXPECT_TRUE(open[1].travels);
}

TEST(NumberWords, SayWhatANameMeans)
{
    const auto label = [](const char* name) { return words_of_number(name).label; };
    EXPECT_EQ(label("transform.translation.x"), "Position X");
    EXPECT_EQ(label("placement.width"), "Width");
    EXPECT_EQ(label("placement.width_profile.2.y"), "Width profile 3 Y");
    EXPECT_EQ(label("material.base_color.x"), "Colour red");
    EXPECT_EQ(label("shaping.0.shift.by.z"), "Step 1 shift move Z");
    EXPECT_EQ(label("camera.picture.eye.x"), "Render camera eye X");
    EXPECT_EQ(label("placement.grid.y"), "Density V");
    EXPECT_EQ(label("render.color_by"), "Colour by");
    EXPECT_EQ(label("hidden"), "Hidden");
    EXPECT_EQ(label("camera.99999999999999999999.eye.x"), "99999999999999999999 eye X");
    EXPECT_EQ(words_of_number("transform.rotation_deg.z").unit, "deg");
    EXPECT_NEAR(words_of_number("render.sun_azimuth").factor, 57.29578, 1e-5);
}

} // namespace
} // namespace trivar
