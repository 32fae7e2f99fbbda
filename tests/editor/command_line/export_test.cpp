// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "editor/command_line/command_line.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr;

// WindowExport exports a scene that is open in the window.
class WindowExport : public ::testing::Test {
protected:
    void open(const std::string& text)
    {
        testing::write_file(disk.file("pot.trivar"), text);
        rig.editor.files.open_scene(disk.file("pot.trivar"));
        rig.wait();
        ASSERT_EQ(rig.editor.session.scene().path(), disk.file("pot.trivar"));
    }
    const ui::Notices::Notice& exported(const std::string& name)
    {
        rig.editor.files.write_model_to(disk.file(name));
        rig.wait();
        return rig.editor.session.notices.all().back();
    }
    std::string verified(Status expected)
    {
        std::ostringstream out, talk;
        EXPECT_EQ(run_program({"verify", disk.file("pot.glb")}, {out, talk}), expected);
        return talk.str();
    }

    testing::TemporaryFolder disk;
    testing::Rig rig;
};

TEST_F(WindowExport, CarriesTheCertificateOfWhatIsRefined)
{
    Refine refine;
    refine.objects = {2};
    open(testing::scene_text() + command_line(refine));
    const ui::Notices::Notice said = exported("pot.glb");
    EXPECT_EQ(said.title, "Exported pot.glb");
    EXPECT_THAT(said.body, HasSubstr("Certified within"));
    EXPECT_THAT(verified(Status::done), HasSubstr("what it claims holds"));
    // Later steps of the log take nothing from what was exported before them.
    rig.editor.session.run(Hide{{2}});
    rig.wait();
    EXPECT_THAT(verified(Status::done), HasSubstr("what it claims holds"));
    rig.editor.session.undo();
    rig.wait();
    EXPECT_THAT(exported("pot.obj").body, HasSubstr("Only a glTF file records this"));
}

TEST_F(WindowExport, TellsWhatIsNotCertified)
{
    Refine coarse;
    coarse.objects = {2};
    coarse.refining.tolerance = 1e-9;
    open(testing::scene_text() + command_line(coarse));
    const ui::Notices::Notice said = exported("pot.glb");
    EXPECT_EQ(said.title, "Exported pot.glb, not all of it certified");
    EXPECT_THAT(said.body, HasSubstr("Teapot (part 1) is not certified"));
    EXPECT_THAT(verified(Status::check_failed), HasSubstr("is not certified"));
}

TEST_F(WindowExport, HasNoCertificateWhereNothingIsRefined)
{
    open(testing::scene_text());
    EXPECT_TRUE(exported("pot.glb").body.empty());
    EXPECT_THAT(verified(Status::rejected), HasSubstr("has no certificate"));
}

TEST_F(WindowExport, TakesThePlaceOfNoFileThatTheSceneIsMadeFrom)
{
    const std::string model = "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n",
                      red = "newmtl m\nKd 1 0 0\n";
    testing::write_file(disk.file("tri.obj"), model);
    testing::write_file(disk.file("red.mtl"), red);
    ImportModel import;
    import.file.path = "tri.obj";
    open(log_header() + command_line(import));
    for (const char* name : {"tri.obj", "red.obj"}) { // the other one's library of materials
        const ui::Notices::Notice said = exported(name);
        EXPECT_EQ(said.title, std::string(name) + " was not written");
        EXPECT_THAT(said.body, HasSubstr("choose another name"));
    }
    EXPECT_EQ(read_text_file(disk.file("tri.obj")), model);
    EXPECT_EQ(read_text_file(disk.file("red.mtl")), red);
    EXPECT_EQ(exported("other.obj").title, "Exported other.obj");
}

TEST_F(WindowExport, OfNothingWithFacesIsNoFile)
{
    open(log_header() + command_line(AddBox{}) + command_line(Hide{{1}}));
    EXPECT_EQ(exported("pot.glb").title, "pot.glb was not written");
    EXPECT_FALSE(std::filesystem::exists(disk.file("pot.glb")));
}

} // namespace
} // namespace trivar
