// SPDX-License-Identifier: GPL-3.0-or-later
// What the preferences do, beside the file they are kept in.
#include "editor/panels/dialogs/preferences_pages.h"

#include "editor/actions/actions.h"
#include "editor/actions/palette_entries.h"
#include "editor/help/about.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar {
namespace {

using testing::Rig;

// A rig whose mouse lies over the picture, a little off its middle.
struct Looking : Rig {
    Looking()
    {
        two_objects();
        move(layout().view.center() + glm::vec2(60, 30));
        before = editor.session.view.camera;
    }
    Camera before;
    const Camera& camera() const { return editor.session.view.camera; }
    double distance() const { return glm::length(camera().eye); }
    void wheel(glm::vec2 steps)
    {
        ui::Event turn = ui::turn_wheel(steps.y);
        turn.at.x = steps.x;
        screen.input().push(turn);
        frames(2);
    }
};

TEST(PreferencesPages, ResetWhatTheyShow)
{
    Rig rig;
    const std::string odd = R"({"scale":1.5,"dock":300,"outliner":300,"timeline":200,
        "timeline_open":true,"loop":false,"light":true,"high_contrast":true,"other_hues":true,
        "lines":2,"tooltip_s":2,"show_dock":false,"hints":false,"at_start":"last",
        "ask_to_keep":false,"reduced_motion":true,"backdrop_as_in_pictures":true,"grid":false,
        "show_axes":false,"show_timing":false,"quality":"high","pace":"30","deform":"one_phase",
        "view_tolerance":"1",
        "threads":1,"mouse_device":"mouse","mouse_emulation":"none","orbit_about":"origin",
        "zoom_to_cursor":false,"reversed_zoom":true,"orbit_speed":2,"pan_speed":2,"zoom_speed":2,
        "double_click_s":1,"click_holds":true,"keys":{"Undo":["U"]},"discarded_days":7,"most_recent":4,
        "scenes_folder":"/a","models_folder":"/b"})";
    const ReadPreferences read = read_preferences(odd);
    ASSERT_TRUE(read.odd.empty()) << read.odd.front();
    rig.editor.preferences = read.preferences;
    auto& dialog = rig.editor.preferences_dialog;
    dialog.open = true;
    for (dialog.page = 0; dialog.page < dialog.page_count; ++dialog.page) {
        reset_preferences_page(rig.editor);
        rig.frames();
    }
    EXPECT_EQ(text_of(rig.editor.preferences), text_of({}));
}

TEST(PreferencesPages, ShowWhoseAKeyIs)
{
    Rig rig({1024, 700});
    auto& dialog = rig.editor.preferences_dialog;
    dialog.open = true;
    dialog.page = dialog.of_keys;
    dialog.seeking = true;
    rig.frames();
    rig.key({.key = 'Z', .ctrl = true});
    EXPECT_EQ(dialog.sought, (ui::Chord{.key = 'Z', .ctrl = true}));
    EXPECT_FALSE(dialog.seeking);
    EXPECT_EQ(rig.steps(), 0u) << "the key was looked for, not used";
    dialog.seeking = true;
    rig.key({ui::key_escape});
    EXPECT_TRUE(dialog.open) << "Esc leaves the looking first";
    EXPECT_FALSE(dialog.seeking);
}

TEST(PreferencesPages, OpenByTheirNamesInThePalette)
{
    Rig rig;
    for (const PaletteEntry& each : palette_preferences(rig.editor)) {
        if (each.note != "page") continue;
        each.run(rig.editor);
        EXPECT_TRUE(rig.editor.preferences_dialog.open);
        EXPECT_EQ(preferences_page_name(rig.editor.preferences_dialog.page), each.name);
    }
    EXPECT_EQ(rig.editor.preferences_dialog.page, PreferencesDialog::of_about);
}

TEST(PreferencesPages, AreGoneThroughByTheArrows)
{
    Rig rig({1024, 700});
    auto& dialog = rig.editor.preferences_dialog;
    dialog.open = true;
    rig.frames();
    rig.key({ui::key_up});
    EXPECT_EQ(dialog.page, dialog.of_general) << "the first";
    for (int page = 1; page < dialog.page_count; ++page) {
        rig.key({ui::key_down});
        EXPECT_EQ(dialog.page, page);
    }
    rig.key({ui::key_down});
    EXPECT_EQ(dialog.page, dialog.of_about) << "the last";
    EXPECT_TRUE(dialog.open);
}

TEST(PreferencesPages, SwitchByTheirNamesInThePalette)
{
    Rig rig;
    for (const PaletteEntry& each : palette_preferences(rig.editor)) {
        if (each.note != "on" && each.note != "off") continue;
        const Preferences before = rig.editor.preferences;
        each.run(rig.editor);
        const bool scale = each.name.starts_with("Interface size");
        EXPECT_TRUE(scale || before != rig.editor.preferences) << each.name;
    }
}

TEST(Mouse, ZoomsTheOtherWayWhereItIsSaidSo)
{
    Looking rig;
    rig.wheel({0, 1});
    const double nearer = rig.distance();
    EXPECT_LT(nearer, glm::length(rig.before.eye));
    rig.editor.session.view.camera = rig.before;
    rig.editor.preferences.mouse.reversed_zoom = true;
    rig.frames(1);
    rig.wheel({0, 1});
    EXPECT_GT(rig.distance(), glm::length(rig.before.eye));
}

TEST(Mouse, ZoomsToTheMiddleWithoutMovingIt)
{
    Looking rig;
    rig.editor.preferences.mouse.zoom_to_cursor = false;
    rig.frames(1);
    rig.wheel({0, 2});
    const auto direction = [](const Camera& c) { return glm::normalize(c.target - c.eye); };
    EXPECT_LT(glm::distance(direction(rig.camera()), direction(rig.before)), 1e-9);
    const glm::dvec3 way = glm::normalize(rig.camera().eye - rig.before.eye);
    EXPECT_LT(glm::distance(way, direction(rig.before)), 0.02); // straight on
}

TEST(Mouse, TwoFingersOrbitAndAWheelZooms)
{
    EXPECT_TRUE(is_fine_scroll({0, 0.25}));
    EXPECT_TRUE(is_fine_scroll({1, 0}));
    EXPECT_FALSE(is_fine_scroll({0, -3}));
    Looking rig;
    rig.editor.preferences.mouse.orbit_about = "origin";
    rig.frames(1);
    rig.wheel({0.5, 0.25});
    EXPECT_NEAR(rig.distance(), glm::length(rig.before.eye), 1e-9);
    EXPECT_GT(glm::distance(rig.camera().eye, rig.before.eye), 0.01);
    rig.editor.preferences.mouse.device = "mouse";
    rig.frames(1);
    rig.wheel({0, 0.5});
    EXPECT_LT(rig.distance(), glm::length(rig.before.eye));
}

TEST(Mouse, OrbitsAsFastAsItIsToldWithTheKeyThatIsChosen)
{
    const auto turned = [](const char* emulation, int key, double speed) {
        Looking rig;
        rig.editor.preferences.mouse = {
            .emulation = emulation, .orbit_about = "origin", .orbit = speed};
        rig.hold(key);
        const glm::vec2 from = rig.layout().view.center() + glm::vec2(60, 30);
        rig.draw({from, from + glm::vec2(40, 0)});
        rig.hold(key, false);
        EXPECT_NEAR(rig.distance(), glm::length(rig.before.eye), 1e-9);
        return glm::distance(rig.camera().eye, rig.before.eye);
    };
    const double at_first = turned("alt", ui::key_left_alt, 1);
    EXPECT_GT(at_first, 0.1);
    EXPECT_GT(turned("alt", ui::key_left_alt, 2), 1.8 * at_first);
    EXPECT_NEAR(turned("super", ui::key_left_super, 1), at_first, 1e-9);
    EXPECT_EQ(turned("super", ui::key_left_alt, 1), 0);
    EXPECT_EQ(turned("none", ui::key_left_alt, 1), 0);
}

TEST(PreferencesPages, CutWhatIsRememberedAndLimitThreads)
{
    Rig rig;
    rig.editor.preferences.recent_scenes = {"a", "b", "c"};
    rig.editor.preferences.most_recent = 2;
    rig.editor.preferences.threads = 1;
    rig.frames(1);
    EXPECT_THAT(rig.editor.preferences.recent_scenes, ::testing::ElementsAre("a", "b"));
    EXPECT_TRUE(rig.editor.memory.of<PreferencesInForce>().limit);
    rig.editor.preferences.threads = 0;
    rig.frames(1);
    EXPECT_FALSE(rig.editor.memory.of<PreferencesInForce>().limit);
}

TEST(PreferencesPages, AskNothingOfUnnamedScenesThatCanBeBroughtBack)
{
    const testing::TemporaryFolder folder;
    Session session([] {}, folder.path().string());
    Recovery recovery(session);
    Files files(session, recovery);
    ASSERT_TRUE(session.run(AddBox{}));
    files.new_scene();
    EXPECT_TRUE(files.asking());
    Files hasty(session, recovery);
    hasty.ask_to_keep = false;
    hasty.new_scene();
    EXPECT_FALSE(hasty.asking());
    EXPECT_EQ(SceneFile::set_aside_in(folder.path().string()).size(), 1u);

    Session in_memory([] {}, {});
    Recovery nowhere(in_memory);
    Files careful(in_memory, nowhere);
    careful.ask_to_keep = false;
    ASSERT_TRUE(in_memory.run(AddBox{}));
    careful.new_scene();
    EXPECT_TRUE(careful.asking()) << "it could not be brought back";
}

TEST(About, NamesEveryLibraryWithItsLicence)
{
    ASSERT_GT(libraries().size(), 15u);
    for (const Library& each : libraries()) {
        EXPECT_FALSE(each.name.empty());
        EXPECT_FALSE(each.licence.empty()) << each.name;
        EXPECT_THAT(about_text("llvmpipe"), ::testing::HasSubstr(each.name));
    }
    EXPECT_EQ(libraries().front().version, IMGUI_VERSION);
    EXPECT_THAT(about_text("llvmpipe"), ::testing::HasSubstr("Graphics: llvmpipe"));
}

} // namespace
} // namespace trivar
