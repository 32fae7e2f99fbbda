// SPDX-License-Identifier: GPL-3.0-or-later
// What replay, render and export do with a scene that is not all there, and with their own sources.
#include "core/base/text.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/text.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "core/scene/log.h"
#include "editor/command_line/command_line.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <set>
#include <sstream>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr, ::testing::Not;
using testing::write_file;

class WholeScene : public ::testing::Test {
protected:
    struct Told {
        Status status;
        std::string text;
    };
    static Told run(const std::vector<std::string>& arguments)
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        return {status, out.str() + talk.str()};
    }
    // A table, and a model of that file.
    void scene_of(const std::string& model, double scale = 1)
    {
        ImportModel import;
        import.name = "Snail";
        import.file.path = model;
        import.file.scale = scale;
        write_file(scene, log_header() + command_line(AddBox{}) + command_line(import));
    }
    std::vector<std::vector<std::string>> every_way_out() const
    {
        return {{"replay", scene, "--export", folder.file("out.glb"), folder.file("out.obj")},
                {"replay", scene, "--timings", folder.file("out.json"), "--digest"},
                {"replay", scene, "--image", folder.file("out.png"), "--size", "32x32"},
                {"render", scene, "--frames", "1:2", "--out", folder.file("out.#.png"), "--size",
                 "32x32"},
                {"render", scene, "--frames", "1:4", "--sheet", "2x2", "--out",
                 folder.file("out.png"), "--size", "32x32"},
                {"export", scene, "--frames", "1:2", "--to", folder.file("out.glb")},
                {"export", scene, "--frames", "1:2", "--to", folder.file("out.usda")},
                {"export", scene, "--frames", "1:2", "--to", folder.file("out.pc2")}};
    }
    std::set<std::string> files() const
    {
        std::set<std::string> out;
        for (const auto& each : fs::recursive_directory_iterator(folder.path()))
            out.insert(each.path().filename().string());
        return out;
    }

    testing::TemporaryFolder folder;
    const std::string scene = folder.file("a.trivar");
};

std::vector<std::string> and_also(std::vector<std::string> words, const std::string& option)
{
    words.push_back(option);
    return words;
}

TEST_F(WholeScene, IsNotWrittenWhereAModelCannotBeRead)
{
    for (const char* model : {"nope.obj", "broken.obj"}) {
        write_file(folder.file("broken.obj"), "v 1 2\n");
        scene_of(model);
        const std::set<std::string> before = files();
        for (const std::vector<std::string>& words : every_way_out()) {
            const Told told = run(words);
            EXPECT_EQ(told.status, Status::rejected) << words[0] << told.text;
            EXPECT_THAT(told.text, HasSubstr(model));
            EXPECT_EQ(files(), before) << words[0];
        }
    }
}

TEST_F(WholeScene, IsWrittenWithoutItWhereThatIsAskedFor)
{
    scene_of("nope.obj");
    for (const std::vector<std::string>& words : every_way_out()) {
        const std::set<std::string> before = files();
        const Told told = run(and_also(words, "--keep-going"));
        EXPECT_EQ(told.status, Status::done) << words[0] << told.text;
        EXPECT_THAT(told.text, HasSubstr("Snail: "));
        EXPECT_THAT(told.text, HasSubstr("nope.obj: there is no such file"));
    }
    for (const char* name : {"out.glb", "out.obj", "out.json", "out.png", "out.1.png", "out.2.png",
                             "out.usda", "out.Box.pc2"})
        EXPECT_TRUE(files().contains(name)) << name;
}

TEST_F(WholeScene, StaysACheckThatFailsWithStatusThree)
{
    scene_of("nope.obj");
    for (const char* more : {"--digest", "--keep-going"})
        EXPECT_EQ(run({"replay", scene, "--check", more}).status, Status::check_failed);
}

TEST_F(WholeScene, WantsTheFontThatATextNamesByItsFile)
{
    AddText text;
    text.shape.font = "missing.ttf";
    write_file(scene, log_header() + command_line(text));
    const Told told = run({"replay", scene, "--export", folder.file("out.glb")});
    EXPECT_EQ(told.status, Status::rejected);
    EXPECT_THAT(told.text, HasSubstr("missing.ttf"));
    EXPECT_FALSE(fs::exists(folder.file("out.glb")));
    EXPECT_EQ(run({"replay", scene, "--export", folder.file("out.glb"), "--keep-going"}).status,
              Status::done);
    text.shape.font = "A family nobody has"; // another one is meant to stand in
    write_file(scene, log_header() + command_line(text));
    EXPECT_EQ(run({"replay", scene, "--export", folder.file("b.glb")}).status, Status::done);
}

TEST_F(WholeScene, WithoutFacesIsNoFile)
{
    for (const std::string& line :
         {std::string(), command_line(AddBox{}) + command_line(Hide{{1}})}) {
        write_file(scene, log_header() + line);
        const std::set<std::string> before = files();
        for (const char* ending : {".glb", ".obj", ".ply", ".stl", ".off"}) {
            const Told told = run({"replay", scene, "--export", folder.file("out") + ending});
            EXPECT_EQ(told.status, Status::rejected);
            EXPECT_THAT(told.text, HasSubstr("there are no faces to write, so nothing is written"));
        }
        for (const char* ending : {".glb", ".usda", ".pc2", ".mdd"})
            EXPECT_EQ(
                run({"export", scene, "--frames", "1", "--to", folder.file("out") + ending}).status,
                Status::rejected);
        EXPECT_EQ(files(), before);
    }
}

TEST_F(WholeScene, SaysOfWhatIsTooLargeThatItIs)
{
    write_file(folder.file("wide.obj"), "v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nf 1 2 3\n");
    for (const double scale : {1e-9, 1.0}) { // by more the reader refuses it
        scene_of("wide.obj", scale);
        const std::set<std::string> before = files();
        for (const std::vector<std::string>& words : every_way_out()) {
            const Told told = run(words);
            EXPECT_EQ(told.status, Status::rejected) << words[0] << told.text;
            EXPECT_THAT(told.text,
                        HasSubstr("Snail: its coordinates are too large (beyond 1e15 m"));
        }
        EXPECT_EQ(files(), before);
    }
    const Told told = run({"info", folder.file("wide.obj"), "--json"});
    EXPECT_EQ(told.status, Status::rejected);
    EXPECT_THAT(told.text, HasSubstr("wide.obj: its coordinates are too large (beyond 1e15 m"));
    EXPECT_THAT(told.text, Not(HasSubstr("null")));
}

TEST_F(WholeScene, WritesOverNoneOfItsSources)
{
    const std::string model = folder.file("snail.obj");
    const auto write_sources = [&] {
        write_file(model, "mtllib snail.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        write_file(folder.file("snail.mtl"), "newmtl m\nKd 1 0 0\n");
    };
    write_sources();
    fs::create_symlink("snail.obj", folder.file("link.obj"));
    fs::create_hard_link(model, folder.file("other name.stl"));
    fs::create_directory(folder.file("sub"));
    scene_of("snail.obj");
    const std::string before = read_text_file(model), log = read_text_file(scene);
    const auto refused = [&](const std::vector<std::string>& words) {
        const Told told = run(words);
        EXPECT_EQ(told.status, Status::rejected) << words[3];
        EXPECT_THAT(told.text, HasSubstr("the scene uses this file"));
        EXPECT_THAT(told.text, HasSubstr("--overwrite"));
        EXPECT_EQ(read_text_file(model), before) << words[3];
        EXPECT_EQ(read_text_file(scene), log);
        EXPECT_EQ(read_text_file(folder.file("snail.mtl")), "newmtl m\nKd 1 0 0\n");
    };
    for (const char* name : {"snail.obj", "link.obj", "other name.stl", "sub/../snail.obj"})
        refused({"replay", scene, "--export", folder.file(name)});
    refused({"replay", scene, "--timings", folder.file("snail.mtl")});
    refused({"replay", scene, "--timings", scene});
    fs::create_hard_link(folder.file("snail.mtl"), folder.file("new.mtl"));
    refused({"replay", scene, "--export", folder.file("new.obj")}); // whose .mtl that is
    fs::create_hard_link(folder.file("snail.mtl"), folder.file("film.Box.mtl"));
    const Told told = run({"replay", scene, "--export", model, "--overwrite"});
    EXPECT_EQ(told.status, Status::done) << told.text;
    EXPECT_NE(read_text_file(model), before);
}

TEST_F(WholeScene, DrawsOverNoneOfItsPictures)
{
    const std::string texture = folder.file("skin.1.png"), model = folder.file("ball.obj");
    Model ball = single_mesh_model("ball", sphere_mesh(1, 8, 4));
    Image picture;
    picture.size_px = {2, 2};
    picture.rgba.assign(16, 255);
    ball.materials.front().base_color_texture.image = make_ref(picture);
    write_model(ball, folder.file("skin.obj")); // with skin_0.png
    fs::rename(folder.file("skin_0.png"), texture);
    write_file(folder.file("skin.mtl"), "newmtl m\nmap_Kd skin.1.png\n");
    write_file(model, "mtllib skin.mtl\n" + read_text_file(folder.file("skin.obj")));
    scene_of("ball.obj");
    const std::string before = read_text_file(texture);
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"replay", scene, "--image", texture},
             {"render", scene, "--frames", "1:2", "--out", folder.file("skin.#.png")},
             {"render", scene, "--frames", "1:2", "--sheet", "1x2", "--out", texture}}) {
        const Told told = run(words);
        EXPECT_EQ(told.status, Status::rejected) << told.text;
        EXPECT_THAT(told.text, HasSubstr("skin.1.png: the scene uses this file"));
        EXPECT_EQ(read_text_file(texture), before);
    }
}

} // namespace
} // namespace trivar
