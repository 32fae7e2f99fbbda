// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/placement.h"
#include "editor/panels/inspector/key_gutter.h"

#include "core/document/parameters.h"
#include "editor/actions/key_actions.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

#include <algorithm>

namespace trivar {
namespace {

using testing::Rig;

// A box, its inspector, and a place that says where its rows are.
struct Inspected : Rig {
    Inspected() : Rig({1024, 900})
    {
        editor.session.run(AddBox{});
        editor.session.selected = 1;
        wait();
    }
    // The mark beside the position, found by looking for what the mouse is over.
    glm::vec2 mark(const std::string& name)
    {
        const ui::Rect r = layout().inspector;
        for (float y = r.lo.y + 8; y < r.hi.y; y += 8) {
            move({r.hi.x - 18, y});
            const auto& under = editor.keys_under_mouse.names;
            if (std::ranges::find(under, name) != under.end()) return {r.hi.x - 18, y + 4};
        }
        ADD_FAILURE() << "no row for " << name;
        return r.lo;
    }
    const Track* track(const std::string& name) const
    {
        return track_of(editor.session.document(), 1, name);
    }
};

TEST(KeyGutter, AClickPutsAKeyOnTheFrameAndAnotherTakesItAway)
{
    Inspected rig;
    const glm::vec2 at = rig.mark("transform.translation.z");
    const std::size_t steps = rig.steps();
    const KeyTarget position{{1}, axes_of("transform.translation")};
    EXPECT_EQ(state_of_keys(rig.editor.session, position), KeyState::none);
    rig.editor.session.show_frame(10);
    rig.click(at);
    EXPECT_EQ(state_of_keys(rig.editor.session, position), KeyState::here);
    ASSERT_TRUE(rig.track("transform.translation.z"));
    EXPECT_EQ(rig.track("transform.translation.z")->keys.front().frame, 10);
    rig.editor.session.show_frame(20);
    EXPECT_EQ(state_of_keys(rig.editor.session, position), KeyState::animated);
    rig.editor.session.show_frame(10);
    rig.click(at);
    EXPECT_FALSE(rig.track("transform.translation.z")) << "its last key takes the track along";
    EXPECT_EQ(rig.steps(), steps + 2);
}

TEST(KeyGutter, TheKeyboardMeansTheNumberUnderTheMouse)
{
    Inspected rig;
    const glm::vec2 at = rig.mark("transform.translation.z");
    rig.move(at - glm::vec2(30, 0)); // the last of the three fields
    EXPECT_EQ(rig.editor.keys_under_mouse, (KeyTarget{{1}, {"transform.translation.z"}}));
    rig.key({'I'});
    EXPECT_TRUE(rig.track("transform.translation.z"));
    EXPECT_FALSE(rig.track("transform.translation.x"));
    rig.key({.key = 'I', .alt = true});
    EXPECT_FALSE(rig.track("transform.translation.z"));
}

TEST(KeyGutter, ARowOfWhichOneNumberHasKeysMeansThatOne)
{
    Inspected rig;
    const glm::vec2 at = rig.mark("transform.translation.z");
    const std::string lift_name = "transform.translation.z";
    ASSERT_TRUE(insert_keys(rig.editor.session, {{1}, {lift_name}}));
    const KeyTarget row{{1}, axes_of("transform.translation")};
    EXPECT_EQ(state_of_keys(rig.editor.session, row), KeyState::here);
    rig.editor.session.show_frame(9);
    rig.click(at);
    EXPECT_EQ(rig.track(lift_name)->keys.size(), 2u);
    EXPECT_FALSE(rig.track("transform.translation.x"));
}

TEST(KeyGutter, OverThePictureTheKeyboardMeansWhereTheSelectedObjectIs)
{
    Inspected rig;
    rig.move(rig.layout().view.center());
    rig.key({'I'});
    EXPECT_EQ(tracks_of(rig.editor.session.document(), 1).size(), 9u);
    rig.editor.session.selected = 0;
    EXPECT_FALSE(is_enabled(rig.editor, action(rig.editor, insert_key_action)));
}

TEST(KeyGutter, NamesOnlyNumbersThatCanHaveKeys)
{
    Rig rig({1024, 700});
    rig.editor.session.replace_scene(testing::typical_scene());
    rig.wait();
    for (const Id id : {2, 3, 0}) {
        rig.editor.session.selected = id;
        rig.frames();
        const ui::Rect r = rig.layout().inspector;
        std::vector<Parameter> known = id == 0
                                           ? scene_parameters(rig.editor.session.document())
                                           : parameters(object(rig.editor.session.document(), id));
        for (int page = 0; page < 6; ++page) {
            for (float y = r.lo.y + 6; y < r.hi.y; y += 12) {
                rig.move({r.hi.x - 20, y});
                for (const std::string& name : rig.editor.keys_under_mouse.names)
                    EXPECT_TRUE(std::ranges::find(known, name, &Parameter::name) != known.end())
                        << name;
            }
            rig.screen.input().push(ui::turn_wheel(-6));
            rig.frames(3);
        }
    }
}

TEST(AutoKey, MakesAKeyOfEveryChangeThatCanBeOne)
{
    Inspected rig;
    action(rig.editor, auto_key_action).run(rig.editor);
    rig.editor.session.show_frame(30);
    ASSERT_TRUE(rig.editor.session.run(SetTransform{1, {.translation = {0, 0, 2}}}));
    ASSERT_TRUE(rig.track("transform.translation.z"));
    EXPECT_FALSE(rig.track("transform.translation.x")) << "it did not change";
    EXPECT_EQ(rig.track("transform.translation.z")->keys.front().value, 2);
    action(rig.editor, auto_key_action).run(rig.editor);
    ASSERT_TRUE(rig.editor.session.run(SetTransform{1, {.translation = {1, 0, 2}}}));
    EXPECT_FALSE(rig.track("transform.translation.x"));
}

TEST(KeyGutter, AnAutomaticSizeGetsAKeyOfWhatIsShown)
{
    Rig rig;
    rig.two_objects();
    Session& session = rig.editor.session;
    ASSERT_TRUE(session.run(testing::placed(2, 1)));
    rig.wait();
    ASSERT_TRUE(session.evaluated().objects.at(2)->placement);
    const PlacementReport report = session.evaluated().objects.at(2)->placement->report;
    ASSERT_EQ(object(session.document(), 2).stroke->parameters.width, 0);
    ASSERT_TRUE(insert_keys(session, {{2}, {"placement.width", "placement.height"}}));
    ASSERT_TRUE(track_of(session.document(), 2, "placement.width"));
    EXPECT_EQ(track_of(session.document(), 2, "placement.width")->keys[0].value,
              report.width_world);
    EXPECT_EQ(track_of(session.document(), 2, "placement.height")->keys[0].value,
              report.height_world);
    rig.wait();
    const PlacementReport keyed = session.evaluated().objects.at(2)->placement->report;
    EXPECT_NEAR(keyed.width_world, report.width_world, 1e-12);
    EXPECT_NEAR(keyed.height_world, report.height_world, 1e-12);
}

TEST(KeyGutter, MarksOnlyNumbersThatThereAre)
{
    Rig rig({1024, 2200});
    Session& session = rig.editor.session;
    ASSERT_TRUE(session.run(AddCylinder{}));
    ASSERT_TRUE(session.run(AddBox{.shape = {.size = {1, 0.2, 0.1}}}));
    PlaceRound round;
    round.object = 2;
    round.around = 1;
    ASSERT_TRUE(session.run(round));
    session.selected = 2;
    rig.wait();
    std::set<std::string> known, marked;
    for (const Parameter& each : parameters(object(session.document(), 2))) known.insert(each.name);
    const ui::Rect r = rig.layout().inspector;
    for (float y = r.lo.y + 8; y < r.hi.y; y += 8) {
        rig.move({r.hi.x - 18, y});
        for (const std::string& name : rig.editor.keys_under_mouse.names) marked.insert(name);
    }
    EXPECT_TRUE(marked.contains("placement.level"));
    for (const std::string& name : marked) EXPECT_TRUE(known.contains(name)) << name;
}

} // namespace
} // namespace trivar
