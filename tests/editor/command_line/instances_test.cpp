// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/tiles/tiles.h"
#include "core/files/read_model.h"
#include "editor/command_line/command_line.h"
#include "editor/files/export_plan.h"
#include "editor/files/export_wish.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using ::testing::AllOf, ::testing::HasSubstr, ::testing::Not;

// A scene with a teapot in a volume and a layer of tiles on a ball, and the program.
class InstancesCommand : public ::testing::Test {
protected:
    struct Ran {
        Status status;
        std::string text;
    };
    InstancesCommand()
    {
        AddSphere ball;
        ball.shape.radius = 0.5;
        AddCylinder stud;
        stud.name = "Stud";
        stud.shape = {.radius = 0.1, .height = 0.05, .segments = 12, .stacks = 2};
        PaintTiles paint;
        paint.object = 4;
        paint.base = 3;
        paint.stroke.brush = TileBrush::fill;
        paint.stroke.size = 0.05;
        paint.stroke.samples = {{{{0, 0, 0.5}, {0, 0, 1}}}};
        testing::write_file(folder.file("a.trivar"), testing::scene_text() + command_line(ball) +
                                                         command_line(stud) + command_line(paint));
    }
    Ran run(std::vector<std::string> arguments) const
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        return {status, out.str() + talk.str()};
    }
    Ran replayed(const std::vector<std::string>& options, const std::string& to = "a.glb") const
    {
        std::vector<std::string> all{"replay", folder.file("a.trivar"), "--export",
                                     folder.file(to)};
        all.insert(all.end(), options.begin(), options.end());
        return run(all);
    }
    testing::TemporaryFolder folder;
};

TEST_F(InstancesCommand, WritesOneTileAndSaysHowFarItIsOff)
{
    const Ran plain = replayed({}, "plain.glb"), made = replayed({"--instances"});
    EXPECT_EQ(plain.status, Status::done);
    EXPECT_THAT(plain.text, Not(HasSubstr("instances")));
    EXPECT_EQ(made.status, Status::done);
    EXPECT_THAT(made.text, AllOf(HasSubstr("a.glb: Stud: "), HasSubstr("tiles are instances")));
    EXPECT_LT(2 * std::filesystem::file_size(folder.file("a.glb")),
              std::filesystem::file_size(folder.file("plain.glb")));
    const auto boxes = [&](const std::string& name) {
        return bounding_box(read_model(folder.file(name)));
    };
    EXPECT_LT(glm::distance(boxes("a.glb").lo, boxes("plain.glb").lo), 0.002);
    EXPECT_LT(glm::distance(boxes("a.glb").hi, boxes("plain.glb").hi), 0.002);
}

TEST_F(InstancesCommand, IsVerifiedWithItsInstances)
{
    EXPECT_EQ(replayed({"--instances", "--epsilon", "0.002"}).status, Status::done);
    const Ran verified = run({"verify", folder.file("a.glb")});
    EXPECT_EQ(verified.status, Status::done) << verified.text;
    EXPECT_THAT(verified.text, HasSubstr("what it claims holds"));
    // A tile that is moved by a millimetre is found out.
    std::string bytes = read_text_file(folder.file("a.glb"));
    bytes[bytes.size() - 30] = static_cast<char>(bytes[bytes.size() - 30] ^ 0x10);
    testing::write_file(folder.file("a.glb"), bytes);
    EXPECT_EQ(run({"verify", folder.file("a.glb")}).status, Status::check_failed);
}

TEST_F(InstancesCommand, KeepsTilesAsTheyAreWithoutTheOption)
{
    EXPECT_EQ(replayed({"--epsilon", "0.002"}).status, Status::done);
    const Ran verified = run({"verify", folder.file("a.glb")});
    EXPECT_EQ(verified.status, Status::done) << verified.text;
    EXPECT_EQ(read_text_file(folder.file("a.glb")).find("gpu_instancing"), std::string::npos);
}

TEST_F(InstancesCommand, IsForFilesThatHaveThem)
{
    const Ran obj = replayed({"--instances"}, "a.obj");
    EXPECT_EQ(obj.status, Status::usage);
    EXPECT_THAT(obj.text, HasSubstr("only a .glb has instances"));
    const Ran clip = run({"export", folder.file("a.trivar"), "--frames", "1", "--instances", "--to",
                          folder.file("clip.glb")});
    EXPECT_EQ(clip.status, Status::usage);
    EXPECT_THAT(clip.text, HasSubstr("only a .usda has instances"));
    const Ran usd = run({"export", folder.file("a.trivar"), "--frames", "1", "--instances", "--to",
                         folder.file("a.usda")});
    EXPECT_EQ(usd.status, Status::done);
    EXPECT_THAT(usd.text, HasSubstr("tiles are instances"));
    EXPECT_NE(read_text_file(folder.file("a.usda")).find("def PointInstancer \"Stud_"),
              std::string::npos);
}

TEST_F(InstancesCommand, AreWrittenByTheWindowToo)
{
    testing::Rig rig;
    rig.editor.files.open_scene(folder.file("a.trivar"));
    rig.wait();
    rig.editor.files.write_model_to(folder.file("window.glb"), true);
    rig.wait();
    const ui::Notices::Notice said = rig.editor.session.notices.all().back();
    EXPECT_EQ(said.title, "Exported window.glb");
    EXPECT_THAT(said.body, HasSubstr("tiles are instances"));
    replayed({"--instances"});
    EXPECT_EQ(read_text_file(folder.file("window.glb")), read_text_file(folder.file("a.glb")));

    ExportPlan plan = usual_export(rig.editor.session, {});
    plan.instances = true;
    EXPECT_FALSE(wish_of(plan, rig.editor.session).scene.instances) << "of a certified clip";
    set_kind(plan, 1);
    const ExportWish wish = wish_of(plan, rig.editor.session);
    EXPECT_TRUE(wish.scene.instances);
    EXPECT_THAT(outlook_of(plan, wish).words, HasSubstr("are instances"));
}

} // namespace
} // namespace trivar
