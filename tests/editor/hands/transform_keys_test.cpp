// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "editor/hands/motion.h"
#include "tests/editor/boxes.h"

namespace trivar {
namespace {

using testing::Boxes, testing::Rig;

TEST(TransformByKey, FollowsTheMouseAndAClickIsOneStep)
{
    Boxes rig;
    rig.key({'G'});
    rig.move(rig.away() + glm::vec2(50, 0));
    rig.wait();
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_GT(rig.of(1).translation.x, -1.5);
    EXPECT_EQ(rig.steps(), 2u);
    rig.click(rig.away() + glm::vec2(80, 0));
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_EQ(rig.editor.session.selected, 1) << "the click only ends the gesture";
    const double px = glm::distance(rig.seen_at(rig.of(1).translation), rig.seen_at({-1.5, 0, 0}));
    EXPECT_NEAR(px, 80, 0.5) << "what is moved stays under the mouse";
}

TEST(TransformByKey, EscapeAndTheRightButtonLeaveNoTrace)
{
    for (const char* how : {"escape", "right"}) {
        Boxes rig;
        rig.key({'S'});
        rig.move(rig.away() + glm::vec2(50, 30));
        rig.wait();
        EXPECT_TRUE(rig.editor.session.proposing());
        if (std::string(how) == "escape") {
            rig.key({ui::key_escape});
        } else {
            rig.screen.input().push(ui::press(ui::Button::right));
            rig.screen.input().push(ui::press(ui::Button::right, false));
            rig.frames(4);
        }
        EXPECT_FALSE(rig.editor.session.proposing());
        EXPECT_FALSE(rig.editor.active_tool().busy());
        EXPECT_EQ(rig.editor.session.scene().history().steps().size(), 2u);
        EXPECT_EQ(rig.of(1).scale, glm::dvec3(1));
    }
}

TEST(TransformByKey, TakesAnAxisAndATypedNumber)
{
    Boxes rig;
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("1.25");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(-1.5, 0, 1.25));
    rig.key({'R'});
    rig.key({'X'});
    rig.type("-45");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.of(1).rotation_deg, glm::dvec3(-45, 0, 0));
    rig.key({'S'});
    rig.type("=2*1.5");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.of(1).scale, glm::dvec3(3));
    EXPECT_EQ(rig.steps(), 5u);
}

TEST(TransformByKey, TabGoesToTheNextNumberAndUnitsCount)
{
    Boxes rig;
    rig.key({'G'});
    rig.type("50 cm");
    rig.key({ui::key_tab});
    rig.key({ui::key_tab});
    rig.type("2");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(-1, 0, 2));
}

TEST(TransformByKey, TheSameAxisAgainIsTheObjectsOwn)
{
    Boxes rig;
    rig.editor.session.run(
        SetTransform{1, {.translation = {-1.5, 0, 0}, .rotation_deg = {0, 0, 90}}});
    rig.wait();
    for (const int times : {1, 2}) {
        rig.key({'G'});
        for (int i = 0; i < times; ++i) rig.key({'X'});
        rig.type("1");
        rig.key({ui::key_enter});
        EXPECT_EQ(rig.of(1).translation,
                  times == 1 ? glm::dvec3(-0.5, 0, 0) : glm::dvec3(-0.5, 1, 0));
    }
}

TEST(TransformByKey, CtrlSnapsToSteps)
{
    Boxes rig;
    rig.key({'G'});
    rig.key({'X'});
    rig.hold(ui::key_left_control);
    rig.move(rig.away() + glm::vec2(43, 0));
    rig.wait();
    rig.key({.key = ui::key_enter, .ctrl = true});
    const double steps = (rig.of(1).translation.x + 1.5) / 0.25;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_GT(steps, 0);
}

TEST(TransformByKey, TheCameraMovesMeanwhileAndWhatWasDoneStays)
{
    Boxes rig;
    rig.key({'G'});
    rig.key({'X'});
    rig.move(rig.away() + glm::vec2(60, 0));
    rig.wait();
    const double moved = rig.of(1).translation.x;
    rig.screen.input().push(ui::turn_wheel(3));
    rig.wait();
    EXPECT_LT(glm::distance(rig.editor.session.view.camera.eye, glm::dvec3(0)), 12);
    EXPECT_NEAR(rig.of(1).translation.x, moved, 1e-9);
    rig.move(rig.away() + glm::vec2(80, 0));
    rig.wait();
    EXPECT_GT(rig.of(1).translation.x, moved + 0.1);
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.steps(), 3u);
}

TEST(TransformByKey, MovesSeveralAboutOnePointOrEachAboutItsOwn)
{
    Boxes rig;
    rig.editor.session.selected.set({1, 2});
    rig.key({'R'});
    rig.key({'Z'});
    rig.type("180");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(1.5, 0, 0));
    EXPECT_EQ(rig.of(2).translation, glm::dvec3(-1.5, 0, 0));
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(verb(rig.editor.session.scene().history().steps()[2].command), "arrange");
    rig.editor.session.undo();
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(-1.5, 0, 0));
}

TEST(TransformByKey, AltResets)
{
    Boxes rig;
    rig.editor.session.selected.set({1, 2});
    rig.key({.key = 'G', .alt = true});
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(0));
    EXPECT_EQ(rig.of(2).translation, glm::dvec3(0));
    EXPECT_EQ(rig.steps(), 3u);
    rig.key({.key = 'S', .alt = true});
    EXPECT_EQ(rig.steps(), 3u) << "there is nothing to reset";
}

TEST(TransformByKey, WhatGoesRoundABodyOffersToBeTakenOff)
{
    Rig rig;
    rig.two_objects();
    ASSERT_TRUE(rig.editor.session.run(AddCylinder{}));
    ASSERT_TRUE(rig.editor.session.run(PlaceRound{2, 3, 0, {}}));
    rig.wait();
    ASSERT_TRUE(object(rig.editor.session.document(), 2).stroke);
    EXPECT_EQ(stands_of(rig.editor.session.document(), {1, 2}).size(), 1u);
    rig.editor.session.selected = 2;
    const std::size_t said = rig.editor.session.notices.all().size();
    rig.key({'G'});
    EXPECT_FALSE(rig.editor.active_tool().busy());
    ASSERT_EQ(rig.editor.session.notices.all().size(), said + 1);
    rig.key({'X'});
    EXPECT_EQ(rig.steps(), 4u) << "an axis is no command of its own";
    const auto& notice = rig.editor.session.notices.all().back();
    ASSERT_EQ(notice.actions.size(), 1u);
    EXPECT_EQ(notice.actions[0].words, "Remove from stroke");
    const auto take_off = notice.actions[0].act; // it may outlive its notice
    take_off();
    EXPECT_EQ(rig.steps(), 5u);
    EXPECT_FALSE(object(rig.editor.session.document(), 2).stroke);
    EXPECT_EQ(rig.editor.session.selected, 2);
    rig.key({'G'});
    EXPECT_TRUE(rig.editor.active_tool().busy());
}

TEST(TransformByKey, MovesACopyFromWhereItsOriginalIs)
{
    Boxes rig;
    rig.key({.key = 'D', .shift = true});
    ASSERT_TRUE(rig.editor.active_tool().busy());
    rig.move(rig.away() + glm::vec2(60, 0));
    rig.click(rig.away() + glm::vec2(60, 0));
    rig.wait();
    EXPECT_EQ(rig.steps(), 4u);
    EXPECT_EQ(rig.editor.session.selected, 3);
    EXPECT_EQ(rig.of(1).translation, glm::dvec3(-1.5, 0, 0));
    EXPECT_GT(rig.of(3).translation.x, -1.5);
}

TEST(TransformByKey, EndsWithTheSceneItBeganIn)
{
    Boxes rig;
    rig.key({'G'});
    rig.move(rig.away() + glm::vec2(60, 0));
    ASSERT_TRUE(rig.editor.active_tool().busy());
    SceneFile other;
    other.run(AddSphere{});
    rig.editor.session.replace_scene(std::move(other));
    rig.wait();
    EXPECT_FALSE(rig.editor.active_tool().busy());
    rig.click(rig.away());
    EXPECT_EQ(rig.of(1), Transform{});
}

TEST(TransformByKey, SaysHowFarWhileItGoesOn)
{
    Boxes rig;
    const auto said = [&] { return rig.editor.active_tool().hints(rig.editor.session)[0].verb; };
    rig.key({'G'});
    EXPECT_EQ(said(), "Move X 0 m   Y 0 m   Z 0 m");
    rig.key({'Y'});
    rig.type("-1.5");
    EXPECT_EQ(said(), "Move Y -1.5| m");
    rig.type("*2");
    EXPECT_EQ(said(), "Move Y -1.5*2| = -3.00 m");
    rig.key({ui::key_escape});
    rig.key({'R'});
    rig.key({'Y'});
    rig.key({'Y'});
    EXPECT_EQ(said(), "Rotate local Y 0°");
    rig.key({ui::key_escape});
    rig.key({'S'});
    rig.key({.key = 'Z', .shift = true});
    EXPECT_EQ(said(), "Scale X Y × 1.00");
}

} // namespace
} // namespace trivar
