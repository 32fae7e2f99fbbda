// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/run_lines.h"

#include "core/files/copies.h"
#include "editor/session/scene_facts.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::AllOf, ::testing::HasSubstr, ::testing::SizeIs;
using testing::Rig;
using testing::TemporaryFolder;

TEST(RunLines, RunsAStepEachAndPassesOverWhatIsNone)
{
    Rig rig;
    run_lines(rig.editor.session,
              "{\"trivar\":1,\"units\":\"m\",\"up\":\"z\"}\r\n\n"
              "{\"do\":\"add_box\",\"note\":\"A box.\"}\n rename object=Box name=Brick \n"
              "{\"undo\":true}\n{\"redo\":true}\n"
              "{\"digest\":\"00000000000000000000000000000000\"}\n");
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_EQ(name_of(rig.editor.session.document(), 1), "Brick");
    ASSERT_THAT(rig.editor.session.notices.all(), SizeIs(1));
    EXPECT_EQ(rig.editor.session.notices.all()[0].title, "4 lines were run");
    EXPECT_EQ(rig.editor.session.scene().history().steps()[0].note, "A box.");
    EXPECT_THAT(rig.editor.session.scene().lines()[1], HasSubstr("\"note\":\"A box.\""));
}

TEST(RunLines, StopsAtTheFirstThatIsRefusedAndSaysWhichInOneNotice)
{
    Rig rig;
    run_lines(rig.editor.session, "add_box\nadd_ball\nadd_torus\n");
    EXPECT_EQ(rig.steps(), 1u);
    ASSERT_THAT(rig.editor.session.notices.all(), SizeIs(1));
    EXPECT_EQ(rig.editor.session.notices.all()[0].title, "Line 2 was refused");
    EXPECT_THAT(rig.editor.session.notices.all()[0].body,
                AllOf(HasSubstr("add_ball"), HasSubstr("The 1 line before stand")));
    EXPECT_FALSE(holds_lines("add_box\n"));
    EXPECT_TRUE(holds_lines("add_box\nadd_box"));
}

TEST(Files, DroppedTogetherAreAStepEachAndWhatIsRefusedIsToldOnce)
{
    const TemporaryFolder disk;
    const auto file = [&](const std::string& name, const std::string& text) {
        std::ofstream(disk.file(name)) << text;
        return disk.file(name);
    };
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::filesystem::create_directory(disk.file("folder"));
    Rig rig;
    rig.screen.input().push(
        ui::drop_files({file("a.obj", triangle), file("b.obj", "f 1 2 9\n"), file("c.max", ""),
                        file("d.obj", triangle), disk.file("folder")}));
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_EQ(name_of(rig.editor.session.document(), 1), "a");
    EXPECT_EQ(name_of(rig.editor.session.document(), 2), "d");
    ASSERT_THAT(rig.editor.session.notices.all(), SizeIs(1));
    EXPECT_EQ(rig.editor.session.notices.all()[0].title, "3 files were not imported");
    EXPECT_THAT(rig.editor.session.notices.all()[0].body,
                AllOf(HasSubstr("c.max: "), HasSubstr("folder: "), HasSubstr("b.obj: ")));
}

TEST(Files, AreCollectedInOneStepThatCanBeUndone)
{
    const TemporaryFolder disk;
    std::ofstream(disk.file("a.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::filesystem::create_directory(disk.file("scene"));
    Rig rig;
    rig.editor.files.import(disk.file("a.obj"));
    rig.wait();
    rig.editor.session.save_as(disk.file("scene/b_002.trivar"));
    rig.editor.files.collect();
    rig.wait();
    EXPECT_TRUE(std::filesystem::exists(disk.file("scene/b_002.assets/a.obj")));
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_THAT(rig.editor.session.evaluated().objects, SizeIs(1));
    rig.editor.files.save_numbered_copy();
    EXPECT_TRUE(std::filesystem::exists(disk.file("scene/b_001.trivar")));
    EXPECT_EQ(numbered_name(disk.file("scene/b_002.trivar")), disk.file("scene/b_003.trivar"));
}

} // namespace
} // namespace trivar
