// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/file_actions.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using testing::Rig;

TEST(RunKeys, OfAnActionThatCannotRunSayWhy)
{
    Rig rig;
    rig.two_objects();
    rig.key({ui::key_keypad_0});
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
    EXPECT_EQ(rig.editor.session.notices.all().back().body, "There is no render camera.");
}

TEST(RunKeys, EscapeClosesADropDownBeforeItsDialog)
{
    Rig rig({1000, 800});
    rig.draw_cheaply();
    rig.editor.preferences_dialog.open = true;
    rig.frames();
    const auto open_lists = [] { return ImGui::GetCurrentContext()->OpenPopupStack.Size; };
    ASSERT_EQ(open_lists(), 1);
    for (float x = 450; x < 900 && open_lists() < 2; x += 50)
        for (float y = 150; y < 650 && open_lists() < 2; y += 14) rig.click({x, y});
    ASSERT_EQ(open_lists(), 2) << "no row of the page has a list";
    rig.key({ui::key_escape});
    EXPECT_EQ(open_lists(), 1);
    EXPECT_TRUE(rig.editor.preferences_dialog.open);
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.preferences_dialog.open);
}

TEST(RunKeys, EnterTakesTheButtonOfADialogThatAsksForAPlan)
{
    const testing::TemporaryFolder folder;
    Rig rig({1000, 800});
    rig.two_objects();
    rig.editor.files.models_folder = folder.path().string();
    ask_export_frames(rig.editor);
    rig.frames();
    rig.key({ui::key_enter});
    EXPECT_FALSE(rig.editor.memory.of<ExportDialog>().open);
    rig.wait();
}

} // namespace
} // namespace trivar
