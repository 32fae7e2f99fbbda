// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/text.h"
#include "core/commands/placement/place.h"
#include "core/commands/volumes/lattice.h"
#include "editor/actions/hint_steps.h"

#include "editor/actions/actions.h"
#include "editor/actions/file_actions.h"
#include "editor/actions/help_actions.h"
#include "editor/panels/foot_cards.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::IsSupersetOf, ::testing::UnorderedElementsAre;
using testing::Rig;

int number(const Rig& rig)
{
    const auto card = hint_card(rig.editor);
    return card ? card->number : -1;
}

TEST(Hints, LeadThroughAFirstStrokeAndDoNotComeBack)
{
    Rig rig;
    EXPECT_EQ(hint_card(rig.editor)->title, "Drop a scene here");
    rig.two_objects();
    EXPECT_EQ(hint_card(rig.editor)->title, "Press D, then draw across the scene");
    rig.key({'D'});
    EXPECT_EQ(hint_card(rig.editor)->title, "Draw across the scene");
    rig.draw(rig.stroke(), false);
    EXPECT_EQ(number(rig), 2);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(number(rig), 3);
    EXPECT_EQ(hint_card(rig.editor)->title, "Drag a white point to change the width");
    auto parameters =
        object(rig.editor.session.document(), rig.editor.session.selected).stroke->parameters;
    parameters.width = 0.5;
    ASSERT_TRUE(
        rig.editor.session.run(EditPlacement{rig.editor.session.selected, parameters, {}, {}}));
    rig.wait();
    EXPECT_EQ(number(rig), -1);
    EXPECT_THAT(rig.editor.preferences.closed_hints,
                UnorderedElementsAre("draw", "let go", "widen"));
    EXPECT_EQ(preferences_from(text_of(rig.editor.preferences)).closed_hints,
              rig.editor.preferences.closed_hints);
    action(rig.editor, show_hints_action).run(rig.editor);
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "Hints are shown again")
        << "there is none to show now";
    rig.editor.preferences.closed_hints = {"draw", "let go", "widen"};
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(number(rig), -1);
    action(rig.editor, show_hints_action).run(rig.editor);
    EXPECT_EQ(number(rig), 1);
}

TEST(Hints, OfferWhatASceneLacks)
{
    Rig rig({1280, 800});
    const auto offers = [&] { return hint_card(rig.editor)->offers; };
    EXPECT_THAT(offers(), ::testing::ElementsAre(import_action)) << "no models were found";
    rig.editor.files.own_models_folder = "models";
    EXPECT_THAT(offers(), IsSupersetOf({"Terrain", "Jar", import_action}));
    ASSERT_TRUE(rig.editor.session.run(AddPlane{}));
    EXPECT_THAT(offers(), IsSupersetOf({"Snake", "Crocodile", import_action}));
    for (const std::string& each : offers())
        EXPECT_TRUE(is_enabled(rig.editor, action(rig.editor, each))) << each;
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    EXPECT_THAT(offers(), ::testing::IsEmpty());
}

TEST(Hints, AreFramedClearOfWhatComesIn)
{
    Rig rig({1024, 700});
    rig.editor.files.own_models_folder = "models";
    rig.editor.start_card.left = rig.editor.session.scenes();
    rig.frames();
    const double foot = rig.editor.session.view.foot_px;
    EXPECT_GT(foot, 100) << "the card with its pictures";
    action(rig.editor, "Torus").run(rig.editor);
    rig.wait();
    float lowest = 0;
    for (const Part& part : rig.editor.session.evaluated().objects.at(1)->parts)
        for (const glm::vec3& p : part.mesh()->positions)
            lowest = std::max(lowest, rig.seen_at(part.to_world * glm::dvec4(p, 1)).y);
    EXPECT_LT(lowest, rig.layout().view.hi.y - rig.editor.session.view.foot_px);
    close_hint(rig.editor, "draw");
    rig.frames();
    EXPECT_EQ(rig.editor.session.view.foot_px, 0);
}

TEST(Hints, SayNothingOfStrokesWhereThingsAreBentInALattice)
{
    Rig rig;
    rig.two_objects();
    ASSERT_EQ(number(rig), 1);
    ASSERT_TRUE(rig.editor.session.run(AddLattice{.objects = {2}}));
    EXPECT_EQ(number(rig), -1);
}

TEST(Hints, AskForAGroundWhereOnlyATextIsThere)
{
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddText{}));
    rig.wait();
    EXPECT_EQ(hint_card(rig.editor)->title, "Now drop a scene to lay the text on");
}

TEST(Hints, StayWhereAStrokeIsCancelled)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke(), false);
    ASSERT_EQ(number(rig), 2);
    rig.key({.key = ui::key_escape});
    EXPECT_EQ(number(rig), 1);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames();
}

TEST(Hints, AreClosedOneByOneByTheirCross)
{
    Rig rig({1024, 700});
    rig.two_objects();
    ASSERT_EQ(number(rig), 1);
    const ui::Rect view = rig.layout().view;
    for (float x = view.center().x; x < view.hi.x && number(rig) == 1; x += 12)
        rig.click({x, view.hi.y - 16 - 64 + 20});
    EXPECT_EQ(number(rig), -1);
    EXPECT_THAT(rig.editor.preferences.closed_hints, UnorderedElementsAre("draw"));
    EXPECT_TRUE(rig.editor.preferences.hints);
    EXPECT_TRUE(is_enabled(rig.editor, action(rig.editor, show_hints_action)));
}

TEST(Hints, TakeTheClicksOnTheirCard)
{
    Rig rig({1024, 700});
    rig.two_objects();
    rig.editor.session.notices.clear();
    rig.frames();
    ASSERT_TRUE(hint_card(rig.editor));
    const ui::Rect view = rig.layout().view;
    const glm::vec2 at{view.center().x, view.hi.y - 40};
    rig.move(at);
    rig.click(at);
    EXPECT_EQ(rig.editor.session.selected, 2);
}

TEST(FootCards, StandOnTheCardsBelowThemAndBesideTheOthers)
{
    FootCards foot({{100, 0}, {900, 600}});
    foot.add({{{400, 540}, {600, 584}}});
    foot.add(std::nullopt);
    EXPECT_EQ(foot.above(112, 380).hi.y, 600);
    EXPECT_EQ(foot.above(112, 412).hi.y, 540);
    EXPECT_EQ(foot.above(600, 800).hi.y, 600) << "they touch";
    foot.add({{{112, 480}, {412, 528}}});
    EXPECT_EQ(foot.above(112, 412).hi.y, 480);
    EXPECT_EQ(foot.above(500, 520).hi.y, 540);
}

} // namespace
} // namespace trivar
