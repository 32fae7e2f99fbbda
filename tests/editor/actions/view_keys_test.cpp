// SPDX-License-Identifier: GPL-3.0-or-later
// What keys change of the window's picture alone.
#include "core/commands/placement/place.h"
#include "core/files/pictures/image.h"
#include "editor/actions/actions.h"
#include "editor/actions/palette_entries.h"
#include "editor/record/record_plan.h"
#include "tests/editor/boxes.h"
#include "tests/support/fixtures.h"

#include <cstdlib>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::Boxes, testing::Rig, testing::TemporaryFolder;
using ::testing::ElementsAre, ::testing::IsEmpty;

// The window at rest.
std::vector<std::uint8_t> picture(Rig& rig)
{
    rig.draw_whole();
    rig.wait();
    rig.screen.settle(rig.body(), 400);
    return rig.screen.picture().rgba;
}

TEST(ViewKeys, ChangeWhatTheWindowShowsAndNothingOfTheScene)
{
    Boxes rig;
    rig.editor.preferences.show_timing = false; // which differs every time
    const std::size_t steps = rig.steps();
    const auto before = picture(rig);
    for (const ui::Chord& key : {ui::Chord{'Z'}, ui::Chord{.key = 'Z', .alt = true},
                                 ui::Chord{.key = 'Z', .shift = true}}) {
        rig.key(key);
        EXPECT_NE(picture(rig), before) << ui::text_of(key);
        rig.key(key);
        EXPECT_EQ(picture(rig), before) << ui::text_of(key);
    }
    EXPECT_EQ(rig.steps(), steps);
}

TEST(ViewKeys, LeaveWhatIsSeenThroughToBePicked)
{
    Boxes rig;
    rig.editor.session.selected = 0;
    for (const ui::Chord& key : {ui::Chord{'Z'}, ui::Chord{.key = 'Z', .alt = true}}) {
        rig.key(key);
        rig.wait();
        rig.click(rig.seen_at(rig.of(2).translation));
        EXPECT_EQ(rig.editor.session.selected, 2) << ui::text_of(key);
        rig.editor.session.selected = 0;
    }
}

TEST(ViewKeys, LookFromSixSidesWithoutPerspectiveUntilTheViewIsTurned)
{
    Boxes rig;
    rig.wait();
    const auto from = [&] {
        const Camera& c = rig.editor.session.view.camera;
        return glm::ivec3(glm::round(glm::normalize(c.eye - c.target)));
    };
    const auto keypad = [](int digit, bool ctrl) {
        return ui::Chord{.key = ui::key_keypad_0 + digit, .ctrl = ctrl};
    };
    const bool& flat = rig.editor.session.view.camera.perspective;
    rig.key(keypad(1, false));
    EXPECT_EQ(from(), glm::ivec3(0, -1, 0));
    EXPECT_FALSE(flat);
    rig.key(keypad(1, true));
    EXPECT_EQ(from(), glm::ivec3(0, 1, 0));
    rig.key(keypad(3, true));
    EXPECT_EQ(from(), glm::ivec3(-1, 0, 0));
    rig.key(keypad(7, true));
    EXPECT_EQ(from(), glm::ivec3(0, 0, -1));
    EXPECT_FALSE(flat);
    const auto side = [&] { return viewpoint_of(rig.editor.session.view.camera); };
    ASSERT_TRUE(side());
    EXPECT_STREQ(side()->name, "Bottom");
    const auto turn = [&] {
        const glm::vec2 at = rig.layout().view.center();
        rig.move(at);
        rig.screen.input().push(ui::press(ui::Button::middle));
        rig.frames();
        rig.move(at + glm::vec2(20, 5));
        rig.move(at + glm::vec2(40, 9));
        rig.screen.input().push(ui::press(ui::Button::middle, false));
        rig.frames();
    };
    turn();
    EXPECT_TRUE(flat) << "it was for the view along an axis alone";
    EXPECT_FALSE(side());
    rig.key(keypad(5, false));
    rig.key(keypad(1, false));
    turn();
    EXPECT_FALSE(flat) << "it was chosen by hand";
}

// Turns the view by a drag from there; what was in the middle stays there.
void turn_from(Rig& rig, glm::vec2 corner)
{
    const glm::dvec3 before = rig.editor.session.view.camera.target;
    rig.move(corner);
    rig.screen.input().push(ui::press(ui::Button::middle));
    rig.frames();
    for (int i = 1; i < 9; ++i) rig.move(corner + glm::vec2(20 * i, 0));
    rig.screen.input().push(ui::press(ui::Button::middle, false));
    rig.frames();
    EXPECT_LT(glm::distance(rig.seen_at(before), rig.layout().view.center()), 2);
}

TEST(ViewKeys, ATurnThatBeginsOverNothingKeepsWhatIsLookedAtInTheMiddle)
{
    Boxes rig;
    rig.wait();
    turn_from(rig, rig.layout().view.lo + glm::vec2(30, 250));
}

TEST(ViewKeys, ATurnThatBeginsOverAFarGroundKeepsWhatIsLookedAtInTheMiddle)
{
    Boxes rig;
    ASSERT_TRUE(rig.editor.session.run(AddPlane{.shape = {.size = {400, 400}}}));
    Camera& camera = rig.editor.session.view.camera;
    camera.eye = {0, -6, 1.5};
    camera.target = {0, 0, 0.5};
    rig.wait();
    const glm::vec2 far = rig.seen_at({5, 60, 0});
    ASSERT_TRUE(rig.layout().view.contains(far));
    turn_from(rig, far);
}

TEST(Isolate, ShowsOnlyWhatIsSelectedTillTheSameKeyIsPressed)
{
    Boxes rig;
    const std::size_t steps = rig.steps();
    rig.key({ui::key_slash});
    rig.wait();
    EXPECT_THAT(rig.editor.session.hidden_here, ElementsAre(2));
    rig.click(rig.seen_at(rig.of(2).translation));
    EXPECT_EQ(rig.editor.session.selected, 0) << "nothing is there";
    rig.key({'A'});
    EXPECT_THAT(rig.editor.session.selected.ids(), ElementsAre(1));
    action(rig.editor, "Torus").run(rig.editor); // what is new is shown
    EXPECT_THAT(rig.editor.session.hidden_here, ElementsAre(2));
    rig.key({ui::key_slash});
    EXPECT_THAT(rig.editor.session.hidden_here, IsEmpty());
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST(Isolate, LeavesWhatIsNotShownOutOfStrokes)
{
    Rig rig;
    rig.two_objects();
    AddPlane shelf; // over all of it
    shelf.shape.size = {6, 6};
    shelf.transform.translation = {0, 0, 2};
    ASSERT_TRUE(rig.editor.session.run(shelf));
    rig.editor.session.selected.set({1, 2});
    rig.key({ui::key_slash});
    rig.editor.session.selected = 2;
    for (const PaletteEntry& each : palette_commands(rig.editor))
        if (each.name == "Place") {
            EXPECT_THAT(each.fill->get<Place>().onto, ElementsAre(1));
        }
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    ASSERT_TRUE(object(rig.editor.session.document(), 2).stroke);
    EXPECT_THAT(object(rig.editor.session.document(), 2).stroke->onto, ElementsAre(1));
}

TEST(DeleteKey, IsNotTheAxisOfAMoveThatWasRefused)
{
    Boxes rig;
    rig.key({'X'});
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
}

TEST(RenderPicture, IsWrittenBesideTheSceneUnderAFreeNumber)
{
    const TemporaryFolder disk;
    Boxes rig;
    const std::string home = std::getenv("HOME");
    ::setenv("HOME", disk.path().c_str(), 1);
    rig.editor.picture_to_file.begin(rig.editor.session, {64, 36});
    ::setenv("HOME", home.c_str(), 1);
    EXPECT_EQ(rig.editor.picture_to_file.path(), disk.file("untitled_001.png"))
        << "a scene without a file has one among the person's pictures";
    rig.editor.picture_to_file.stop();
    rig.editor.session.save_as(disk.file("a.trivar"));
    rig.wait();
    rig.editor.picture_to_file.begin(rig.editor.session, {64, 36});
    for (int i = 0; i < 1000 && rig.editor.picture_to_file.running(); ++i) rig.frames(1);
    rig.wait();
    EXPECT_TRUE(std::filesystem::exists(disk.file("a_001.png")));
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "a_001.png was written");
}

TEST(RenderPicture, HasTheSizeThatRecordingsHaveWhateverTheWindowIs)
{
    const TemporaryFolder disk;
    Boxes rig;
    rig.editor.session.save_as(disk.file("a.trivar"));
    rig.wait();
    auto& plan = rig.editor.memory.of<RecordDialog>().plan;
    plan.width_px = 96;
    plan.height_px = 54;
    rig.key({ui::key_f1 + 11});
    for (int i = 0; i < 1000 && rig.editor.picture_to_file.running(); ++i) rig.frames(1);
    rig.wait();
    const Image image = read_image(disk.file("a_001.png"));
    EXPECT_EQ(image.size_px, glm::ivec2(96, 54));
}

TEST(RenderPicture, IsDrawnAnewWhereTheGraphicsCardIsResetMeanwhile)
{
    const TemporaryFolder disk;
    Boxes rig;
    rig.editor.session.save_as(disk.file("a.trivar"));
    rig.wait();
    rig.editor.picture_to_file.begin(rig.editor.session, {64, 36});
    for (int i = 0; i < 3; ++i) rig.frames(1);
    rig.screen.lose_context([&] { rig.editor.lose_context(); });
    for (int i = 0; i < 1000 && rig.editor.picture_to_file.running(); ++i) rig.frames(1);
    rig.wait();
    EXPECT_TRUE(std::filesystem::exists(disk.file("a_001.png")));
}

} // namespace
} // namespace trivar
