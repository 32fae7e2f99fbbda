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
