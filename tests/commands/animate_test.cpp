// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "tests/support/scenes/commands.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::ThrowsMessage;
using testing::small_document, testing::new_evaluator;

Document animated(const Document& document, Id id, std::vector<Track> tracks)
{
    return after(document, Animate{{{id, std::move(tracks)}}});
}

double value_of(const std::vector<Parameter>& parameters, const std::string& name)
{
    const auto found = std::ranges::find(parameters, name, &Parameter::name);
    return found == parameters.end() ? std::nan("") : found->value;
}

// The pot with profiles, pressed, and in a material of its own.
Document rich_document()
{
    Document document = after(small_document(), SetMaterial{{3}, {}});
    PlacementParameters p;
    p.width_profile = {{0, 1}, {0.5, 2}, {1, 1}};
    p.height_map = {{1, 1}, {1, 2}};
    document = after(document, EditPlacement{3, p, {}, {}});
    document = after(document, PressVolume{3, {.samples = {{0.5, 0.5, 1, 0.02}}}});
    return after(document, Refine{{3}, {}});
}

TEST(Animate, KeysAreSharedWhereSomethingElseOfTheirObjectChanges)
{
    const Document keyed = animated(small_document(), 2, {{"hidden", {{1, 0}, {9, 1}}}});
    const Document renamed = after(keyed, Rename{2, "Other"});
    EXPECT_EQ(&object(keyed, 2).tracks[0], &object(renamed, 2).tracks[0]);
    const Document more = animated(renamed, 2, {{"hidden", {{1, 0}, {9, 0}}}});
    EXPECT_EQ(object(keyed, 2).tracks[0].keys[1].value, 1) << "what was, is as it was";
    EXPECT_FALSE(object(more, 2).tracks == object(renamed, 2).tracks);
    EXPECT_TRUE(object(animated(more, 2, {{"hidden", {{1, 0}, {9, 1}}}}), 2).tracks ==
                object(keyed, 2).tracks)
        << "equal by value";
}

TEST(Animate, MovesEveryParameterThatThereIs)
{
    const Document document = rich_document();
    const auto check = [&](Id id, const std::vector<Parameter>& all, const auto& now) {
        std::set<std::string> names;
        for (const Parameter& p : all) {
            EXPECT_TRUE(names.insert(p.name).second) << p.name << " is there twice";
            const double step = p.stays() ? 1 : 0.125;
            const double to = p.value + step <= p.hi ? p.value + step : p.value - step;
            const Document moved = animated(document, id, {{p.name, {{1, to}}}});
            EXPECT_NEAR(value_of(now(document_at(moved, 7)), p.name), to, 1e-6) << p.name;
        }
        return names;
    };
    const std::set<std::string> pot =
        check(3, parameters(object(document, 3)),
              [](const Document& d) { return parameters(object(d, 3)); });
    for (const char* name : {"transform.rotation_deg.z",
                             "hidden",
                             "shape.height",
                             "material.base_color.x",
                             "placement.width",
                             "placement.width_profile.1.y",
                             "placement.height_map.1.0",
                             "placement.fill",
                             "shaping.0.press.radius",
                             "shaping.0.press.samples.0.w",
                             "refining.tolerance",
                             "shape.resolution",
                             "material.solid",
                             "placement.grid.y",
                             "placement.misses",
                             "placement.sharp",
                             "placement.on_ground",
                             "travel.followers",
                             "travel.gap",
                             "shaping.0.press.decay",
                             "refining.method"})
        EXPECT_TRUE(pot.contains(name)) << name;
    const std::set<std::string> scene =
        check(0, scene_parameters(document), [](const Document& d) { return scene_parameters(d); });
    for (const char* name : {"render.exposure", "render.sun_azimuth", "camera.front.eye.z",
                             "render.look", "render.color_by", "render.shadows"})
        EXPECT_TRUE(scene.contains(name)) << name;
    EXPECT_FALSE(scene.contains("camera.front.size_px.x"));
}

TEST(Animate, LetsCountsChoicesAndSwitchesStayUntilTheNextKey)
{
    Document document = animated(rich_document(), 3,
                                 {{"hidden", {{1, 0}, {9, 1}}},
                                  {"travel.followers", {{1, 2}, {9, 6.2, Tween::linear}, {12, 8}}},
                                  {"material.solid", {{1, 0}, {9, 2}}}});
    document = animated(document, 0, {{"render.look", {{1, 2}, {9, 1}}}});
    const Document before = document_at(document, 8.9), then = document_at(document, 9);
    EXPECT_FALSE(object(before, 3).hidden);
    EXPECT_TRUE(object(then, 3).hidden);
    EXPECT_EQ(object(before, 3).travel.followers, 2);
    EXPECT_EQ(object(document_at(document, 11), 3).travel.followers, 6);
    EXPECT_EQ(object(before, 3).surfacing->filling, Filling::none);
    EXPECT_EQ(object(then, 3).surfacing->filling, Filling::flesh);
    EXPECT_EQ(before.render->look, "dark");
    EXPECT_EQ(then.render->look, "clay");
    for (const Track& track : object(document, 3).tracks)
        for (const Key& key : track.keys) {
            EXPECT_EQ(key.tween, Tween::step) << track.parameter;
            EXPECT_EQ(key.value, std::round(key.value)) << track.parameter;
        }
}

TEST(Animate, LeavesWhatHasNoKeysAsItIs)
{
    const Document still = rich_document();
    const Document document = animated(still, 2, {{"transform.translation.z", {{1, 0}, {11, 1}}}});
    const Document at = document_at(document, 6);
    for (const Id id : {1, 3, 4}) EXPECT_EQ(at.objects.at(id), document.objects.at(id));
    EXPECT_EQ(object(at, 2).transform.translation, glm::dvec3(0, 0, 0.5));
    EXPECT_EQ(document_at(at, 6).objects.at(2), at.objects.at(2)) << "again, nothing changes";
    EXPECT_EQ(digest(document_at(still, 6)), digest(still));
    EXPECT_NE(digest(document), digest(still));
}

TEST(Animate, ShowsAFrameDirectlyAsItDoesAfterAllBeforeIt)
{
    const Document document =
        animated(animated(small_document(), 2,
                          {{"transform.translation.x", {{1, 0}, {12, 1}}},
                           {"shape.radius", {{1, 0.4}, {6, 0.2, Tween::linear}, {9, 0.5}}}}),
                 3, {{"placement.height", {{1, 0.1}, {10, 0.4}}}});
    Evaluator playing = new_evaluator();
    std::set<std::string> seen;
    for (int frame = 1; frame <= 12; ++frame) {
        const std::string played = digest(playing(document, frame));
        EXPECT_EQ(played, digest(new_evaluator()(document, frame))) << frame;
        seen.insert(played);
    }
    EXPECT_GE(seen.size(), 11u) << "it moves";
}

TEST(Animate, TakesValuesBeyondARangeToItsEndAndNoScaleToZero)
{
    Key far{1, 0.9, Tween::cubic, {}, {3, 5}};
    const Document document =
        animated(rich_document(), 3, {{"material.roughness", {far, {10, 1}}}});
    for (int frame = 1; frame < 10; ++frame)
        EXPECT_LE(object(document_at(document, frame), 3).surfacing->roughness, 1);
    const Document flat =
        animated(small_document(), 2, {{"transform.scale.y", {{0, -1, Tween::linear}, {2, 1}}}});
    EXPECT_GT(object(document_at(flat, 1), 2).transform.scale.y, 0);
}

TEST(Animate, AKeptViewThatWouldLookNowhereStays)
{
    const Document document = small_document();
    const Camera camera = document.kept_views.at("front");
    const Document moved = animated(document, 0,
                                    {{"camera.front.target.x", {{1, camera.eye.x}}},
                                     {"camera.front.target.y", {{1, camera.eye.y}}},
                                     {"camera.front.target.z", {{1, camera.eye.z}}}});
    EXPECT_EQ(document_at(moved, 1).kept_views.at("front"), camera);
}

TEST(Animate, ReplacesAndTakesAwayOneTrackAtATime)
{
    Document document = animated(
        small_document(), 2, {{"transform.translation.x", {{1, 0}, {9, 1}}}, {"hidden", {{5, 1}}}});
    ASSERT_EQ(object(document, 2).tracks.size(), 2u);
    EXPECT_EQ(object(document, 2).tracks[0].parameter, "hidden") << "by name";
    document = animated(document, 2, {{"hidden", {{5, 1}, {7, 0}}}});
    EXPECT_EQ(object(document, 2).tracks[0].keys.size(), 2u);
    document = animated(document, 2, {{"hidden", {}}});
    ASSERT_EQ(object(document, 2).tracks.size(), 1u);
    document = animated(document, 2, {{"transform.translation.x", {}}});
    EXPECT_EQ(digest(document), digest(small_document()));
}

TEST(Animate, GoesWithCopies)
{
    const Document document =
        animated(rich_document(), 3, {{"placement.width", {{1, 0.2}, {9, 0.3}}}});
    const Document twice = after(document, Duplicate{{3}, {}});
    EXPECT_EQ(object(twice, document.next_id).tracks, object(document, 3).tracks);
    const Paste paste = copied(document, {3}, ".");
    EXPECT_EQ(command_from_json_line(to_json_line(paste)), Command(paste));
    const Document pasted = after(document, paste);
    EXPECT_EQ(object(pasted, document.next_id).tracks, object(document, 3).tracks);
    const Document alone = after(Document{}, paste);
    EXPECT_TRUE(object(alone, 1).tracks.empty()) << "there is no stroke";
}

TEST(Animate, OutlivesWhatItMoves)
{
    const Document document = animated(rich_document(), 3, {{"placement.width", {{1, 0.2}}}});
    const Document off = after(document, Unplace{3});
    EXPECT_EQ(object(off, 3).tracks.size(), 1u);
    EXPECT_NO_THROW(new_evaluator()(off, 3));
    EXPECT_TRUE(object(animated(off, 3, {{"placement.width", {}}}), 3).tracks.empty());
}

TEST(Animate, RefusesWhatCannotBe)
{
    const Document document = rich_document();
    const auto refused = [&](Id id, std::vector<Track> tracks, const char* why) {
        EXPECT_THAT([&] { animated(document, id, tracks); },
                    ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(3, {}, "\"tracks\" is empty");
    refused(9, {{"hidden", {{1, 1}}}}, "no object 9");
    refused(3, {{"placement.wdth", {{1, 1}}}}, "no parameter \"placement.wdth\"");
    refused(2, {{"placement.width", {{1, 1}}}}, "no parameter");
    refused(0, {{"transform.scale.x", {{1, 1}}}}, "the scene has no parameter");
    refused(3, {{"placement.width", {{5, 1}, {5, 2}}}}, "are not in order");
    refused(3, {{"placement.fill", {{5, 1.5}}}}, "must lie between 0.001 and 1");
    refused(3, {{"hidden", {{5, 2}}}}, "between 0 and 1");
    refused(3, {{"material.solid", {{5, 4}}}}, "between 0 and 3");
    refused(3, {{"placement.grid.x", {{5, 1}}}}, "between 2 and 1024");
    refused(3, {{"hidden", {{5, 1, Tween::cubic, {1, 0}}}}}, "wrong way");
    refused(3, {{"hidden", {{std::nan(""), 1}}}}, "frame");
}

} // namespace
} // namespace trivar
