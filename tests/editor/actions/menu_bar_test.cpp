// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "editor/actions/menu_letters.h"
#include "editor/panels/menu_bar.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using ::testing::ElementsAre;
using testing::Rig;

TEST(MenuLetters, AreTheFirstThatAreFree)
{
    EXPECT_THAT(menu_letters({"Open...", "Open recent", "Options", "O"}),
                ElementsAre('O', 'P', 'T', 0));
    EXPECT_THAT(menu_letters({"File", "Add"}, "AF"), ElementsAre('I', 'D'));
}

TEST(MenuBar, OpensByALetterAndShowsWhichEntryHasTheKeyboard)
{
    Rig rig({1024, 700});
    rig.frames();
    rig.key({.key = 'F', .alt = true});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "File");
    EXPECT_NE(GImGui->NavId, 0u);
    EXPECT_FALSE(GImGui->NavDisableHighlight);
    rig.key({.key = 'E', .alt = true});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "Edit");
    rig.key({ui::key_right});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "Select");
    EXPECT_NE(GImGui->NavId, 0u);
    rig.key({ui::key_left});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "Edit");
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "");
}

TEST(MenuBar, AMenuThatIsHigherThanTheWindowStaysBelowItsTitleAndScrolls)
{
    Rig rig({1280, 800}, {.scale = 2});
    rig.frames();
    for (const char letter : {'F', 'E', 'V'}) {
        rig.key({.key = letter, .alt = true});
        ASSERT_GT(GImGui->OpenPopupStack.Size, 0);
        const ImGuiWindow* menu = GImGui->OpenPopupStack[0].Window;
        ASSERT_TRUE(menu);
        EXPECT_GE(menu->Pos.y, rig.layout().top.hi.y - 1) << letter;
        EXPECT_LE(menu->Pos.y + menu->Size.y, 800) << letter;
        rig.key({ui::key_escape});
    }
}

TEST(MenuBar, AnEntryRunsByItsLetter)
{
    Rig rig({1024, 700});
    rig.frames();
    const bool shown = rig.editor.preferences.show_dock;
    rig.key({.key = 'V', .alt = true});
    ASSERT_EQ(rig.editor.memory.of<MenuBar>().open, "View");
    std::vector<std::string> entries;
    for (const Action& each : rig.editor.actions)
        if (each.menu == "View") entries.push_back(each.name);
    const std::vector<char> letters = menu_letters(entries);
    const auto at = std::ranges::find(entries, "Side panels") - entries.begin();
    rig.key({letters[static_cast<std::size_t>(at)]});
    EXPECT_NE(rig.editor.preferences.show_dock, shown);
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "");
}

TEST(MenuBar, EnterRunsTheFirstEntryAtOnce)
{
    Rig rig({1024, 700});
    rig.frames();
    rig.editor.session.view.camera.eye = {9, 9, 9};
    rig.key({.key = 'F', .alt = true});
    rig.key({ui::key_enter}); // New scene
    EXPECT_EQ(rig.editor.session.view.camera.eye, Camera{}.eye);
}

TEST(MenuBar, EscapeClosesItAndLeavesTheToolInTheHand)
{
    Rig rig({1024, 700});
    rig.two_objects();
    rig.key({'D'});
    const std::string tool = rig.editor.active_tool().name();
    ASSERT_EQ(tool, "Place");
    rig.key({.key = 'E', .alt = true});
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "");
    EXPECT_EQ(rig.editor.active_tool().name(), tool);
}

TEST(MenuBar, LeavesKeysWithAltToTheActionsThatHaveThem)
{
    Rig rig({1024, 700});
    rig.two_objects();
    rig.key({.key = 'A', .alt = true}); // nothing selected, not the menu Add
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "");
    EXPECT_EQ(rig.editor.session.selected, 0u);
}

TEST(MenuBar, TheRightKeyOpensAMenuBesideAtItsFirstEntryAndTheLeftClosesIt)
{
    const testing::TemporaryFolder folder;
    Rig rig({1024, 700});
    for (const char* name : {"b.trivar", "a.trivar"}) {
        testing::write_file(folder.file(name), " ");
        rig.editor.preferences.recent_scenes.push_back(folder.file(name));
    }
    rig.frames();
    rig.key({.key = 'F', .alt = true});
    rig.key({ui::key_down});
    rig.key({ui::key_down}); // Open recent
    const unsigned entry = GImGui->NavId;
    rig.key({ui::key_right});
    EXPECT_EQ(GImGui->OpenPopupStack.Size, 2);
    EXPECT_NE(GImGui->NavId, entry);
    EXPECT_NE(GImGui->NavId, 0u);
    EXPECT_FALSE(GImGui->NavDisableHighlight);
    EXPECT_EQ(GImGui->NavWindow, GImGui->OpenPopupStack[1].Window);
    rig.key({ui::key_left});
    EXPECT_EQ(GImGui->OpenPopupStack.Size, 1);
    EXPECT_EQ(GImGui->NavId, entry);
    EXPECT_EQ(rig.editor.memory.of<MenuBar>().open, "File");
    rig.key({ui::key_right});
    rig.key({ui::key_enter});
    EXPECT_EQ(GImGui->OpenPopupStack.Size, 0) << "the first entry was chosen";
}

} // namespace
} // namespace trivar
