// SPDX-License-Identifier: GPL-3.0-or-later
// Every option that opens a file refuses what is none, at once: a pipe would wait for ever, a
// device may never end.
#include "core/commands/objects/import.h"
#include "core/commands/objects/text.h"
#include "core/scene/log.h"
#include "editor/command_line/command_line.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>
#include <sys/stat.h>

namespace trivar {
namespace {

using ::testing::AnyOf, ::testing::HasSubstr;

class OddFiles : public ::testing::Test {
protected:
    OddFiles()
    {
        ::mkfifo(pipe.c_str(), 0600);
        for (const char* ending : {".glb", ".obj", ".png", ".usda", ".pc2", ".trivar", ".ttf"})
            std::filesystem::create_symlink(pipe, pipe + ending);
        for (const char* ending : {".glb", ".obj", ".png", ".usda", ".trivar"}) {
            std::filesystem::create_symlink("/dev/zero", folder.file("zero") + ending);
            std::filesystem::create_symlink("/dev/full", folder.file("full") + ending);
            std::filesystem::create_directory(folder.file("folder") + ending);
        }
        write(command_line(AddBox{}));
    }
    void write(const std::string& lines) const { testing::write_file(scene, log_header() + lines); }
    static void refuses(const std::vector<std::string>& arguments)
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        EXPECT_EQ(status, Status::rejected) << arguments[0] << " " << arguments.back();
        EXPECT_THAT(talk.str(),
                    AnyOf(HasSubstr("not an ordinary file"), HasSubstr("cannot be opened: ")));
    }

    testing::TemporaryFolder folder;
    const std::string scene = folder.file("a.trivar"), pipe = folder.file("pipe");
};

TEST_F(OddFiles, AreNotReadAsScenesOrModels)
{
    for (const char* what : {"pipe", "zero", "folder"}) {
        const std::string log = folder.file(what) + ".trivar", model = folder.file(what) + ".glb";
        refuses({"replay", log});
        refuses({"render", log, "--frames", "1:2", "--out", folder.file("a.#.png")});
        refuses({"export", log, "--to", folder.file("a.glb")});
        refuses({"info", log});
        refuses({"info", model});
        refuses({"info", folder.file(what) + ".png"});
        refuses({"verify", model});
        refuses({"verify", pipe});
    }
    refuses({"verify", "/dev/zero"});
}

TEST_F(OddFiles, AreNoSceneOfAnExport)
{
    std::ostringstream out, talk;
    ASSERT_EQ(
        run_program({"export", scene, "--frames", "1", "--to", folder.file("a.glb")}, {out, talk}),
        Status::done)
        << talk.str();
    for (const char* what : {"pipe", "zero", "folder"})
        refuses({"verify", folder.file("a.glb"), "--log", folder.file(what) + ".trivar"});
}

TEST_F(OddFiles, AreNotReadInPlaceOfWhatASceneNames)
{
    ImportModel import;
    import.file.path = "snail.obj";
    AddText text;
    text.shape.font = pipe + ".ttf";
    for (const char* what : {"pipe", "zero", "folder"}) {
        import.file.path = "snail.obj";
        write(command_line(import));
        refuses({"replay", scene, "--set", "snail.obj=" + folder.file(what) + ".obj"});
        import.file.path = std::string(what) + ".obj";
        write(command_line(import));
        refuses({"replay", scene});
    }
    write(command_line(text));
    std::ostringstream out, talk;
    EXPECT_EQ(run_program({"replay", scene}, {out, talk}), Status::rejected);
    EXPECT_THAT(talk.str(), HasSubstr("pipe.ttf cannot be opened"));
}

TEST_F(OddFiles, AreNotWrittenOver)
{
    for (const char* what : {"pipe", "full", "folder"}) {
        const std::string to = folder.file(what);
        for (const char* ending : {".glb", ".obj"})
            refuses({"replay", scene, "--export", to + ending});
        refuses({"replay", scene, "--image", to + ".png"});
        refuses({"replay", scene, "--timings", to + ".png"});
        refuses({"export", scene, "--to", to + ".glb"});
        refuses({"export", scene, "--to", to + ".usda"});
        refuses({"render", scene, "--frames", "1:2", "--sheet", "1x2", "--out", to + ".png"});
    }
    std::filesystem::create_symlink(pipe, folder.file("f.1.png"));
    refuses({"render", scene, "--frames", "1:2", "--out", folder.file("f.#.png")});
    std::filesystem::create_symlink("/dev/full", folder.file("b.Box.pc2"));
    refuses({"export", scene, "--frames", "1", "--to", folder.file("b.pc2")});
}

TEST_F(OddFiles, AreNoShaders)
{
    for (const char* inside : {"gpu/shaders", "core/kernel"})
        std::filesystem::create_directories(folder.path() / inside);
    std::filesystem::create_symlink(pipe, folder.path() / "gpu/shaders/a.glsl");
    refuses(
        {"replay", scene, "--image", folder.file("a.png"), "--shaders", folder.path().string()});
}

} // namespace
} // namespace trivar
