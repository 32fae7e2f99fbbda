// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/tetrahedra.h"
#include "editor/command_line/command_line.h"

#include "core/base/text.h"
#include "core/files/pictures/image.h"
#include "core/scene/log.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/voxels/volume_writers.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::IsEmpty, ::testing::Not;
using testing::scene_text, testing::TemporaryFolder, testing::write_file;

struct Ran {
    Status status;
    std::string out, talk;
};

Ran run(const std::vector<std::string>& arguments)
{
    std::ostringstream out, talk;
    const Status status = run_program(arguments, {out, talk});
    return {status, out.str(), talk.str()};
}

TEST(CommandLine, HelpIsAResultAndSpeaksOfExitStatuses)
{
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--help"},
                                               {"replay", "--help"},
                                               {"info", "--help"},
                                               {"bench", "--help"},
                                               {"commands", "--help"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.status, Status::done);
        EXPECT_THAT(ran.out, HasSubstr("trivar"));
        EXPECT_THAT(ran.talk, IsEmpty());
    }
    EXPECT_THAT(run({"--help"}).out, HasSubstr("3 a check failed"));
    EXPECT_THAT(run({"--version"}).out, HasSubstr("Trivar "));
}

TEST(CommandLine, WrongUsageIsStatusTwoAndNoResult)
{
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"replay"},
                                               {"--wings"},
                                               {"exprot", "x"},
                                               {"replay", "a", "--to", "x"},
                                               {"replay", "a", "--frame", "x"},
                                               {"replay", "a", "--size", "9x"},
                                               {"replay", "a", "--set", "triangle.obj"},
                                               {"commands", "--json", "--markdown"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.status, Status::usage);
        EXPECT_THAT(ran.out, IsEmpty());
        EXPECT_THAT(ran.talk, Not(IsEmpty()));
    }
}

TEST(CommandLine, ListsCommands)
{
    EXPECT_THAT(run({"commands"}).out, HasSubstr("add_teapot"));
    EXPECT_GT(nlohmann::json::parse(run({"commands", "--json"}).out).size(), 20u);
    EXPECT_EQ(run({"commands", "--markdown"}).out, commands_markdown());
}

TEST(Replay, RejectsWithFileAndLine)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, log_header() + "{\"do\":\"fly\"}\n");
    const Ran ran = run({"replay", path});
    EXPECT_EQ(ran.status, Status::rejected);
    EXPECT_THAT(ran.talk, HasSubstr(path + ":2: there is no command"));
    EXPECT_EQ(run({"replay", folder.file("missing.trivar")}).status, Status::rejected);
    EXPECT_EQ(run({"replay", folder.path().string()}).status, Status::rejected);
    EXPECT_EQ(run({"replay", "/dev/zero"}).status, Status::rejected);
}

TEST(Replay, ShowsWhatMovesInTheFrameThatIsAskedFor)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path,
               scene_text() + command_line(SetTravel{{2}, {.speed = 1, .ends = Ends::run_on}}));
    const auto at = [&](const std::string& frame) {
        const std::string out = folder.file("a" + frame + ".ply");
        const Ran ran = run({"replay", path, "--frame", frame, "--check", "--export", out});
        EXPECT_EQ(ran.status, Status::done) << ran.talk;
        return read_text_file(out);
    };
    ASSERT_EQ(run({"replay", path, "--export", folder.file("a.ply")}).status, Status::done);
    EXPECT_TRUE(at("1") == read_text_file(folder.file("a.ply")));
    EXPECT_FALSE(at("48") == at("1"));
    const Ran beyond = run({"replay", path, "--frame", "241"});
    EXPECT_EQ(beyond.status, Status::rejected);
    EXPECT_THAT(beyond.talk, HasSubstr("--frame 241: the scene's frames are 1 to 240"));
}

TEST(Replay, SaysWhatIsProvenOfEachVolume)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text());
    EXPECT_THAT(run({"replay", path, "--check"}).talk,
                HasSubstr("Teapot: its volume folds nowhere, proven; it meets itself nowhere, "
                          "proven"));
    PointShift far{.points = {{16, 4, 3}}, .by = {1, 0, 0}, .guard = false};
    write_file(path, scene_text() + command_line(MovePoints{2, far}));
    EXPECT_THAT(run({"replay", path, "--check"}).talk, HasSubstr("Teapot: its volume folds in "));
    write_file(path, scene_text() + command_line(AllowFolds{2, FoldAllowance{{VolumePart{}}}}) +
                         command_line(MovePoints{2, far}));
    EXPECT_THAT(run({"replay", path, "--check"}).talk,
                HasSubstr("Teapot: its volume folds only where that is allowed, proven"));
}

TEST(Replay, ChecksItsOwnDigestsWithAnyNumberOfThreads)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text());
    const Ran printed = run({"replay", path, "--digest"});
    ASSERT_EQ(printed.status, Status::done) << printed.talk;
    write_file(path, scene_text() + printed.out);
    for (const char* threads : {"1", "2"}) {
        const Ran ran = run({"replay", path, "--check", "--threads", threads});
        EXPECT_EQ(ran.status, Status::done) << ran.talk;
    }
}

TEST(Replay, ChecksThatTheFileIsWhole)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text() + "{\"do\": \"add_b");
    EXPECT_EQ(run({"replay", path}).status, Status::done);
    const Ran checked = run({"replay", path, "--check"});
    EXPECT_EQ(checked.status, Status::check_failed);
    EXPECT_THAT(checked.talk, HasSubstr("the last line is incomplete"));
}

TEST(Replay, StoresTheDigestOfTheResultInAFrame)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    const std::string moving =
        scene_text() + command_line(SetTravel{{2}, {.speed = 1, .ends = Ends::run_on}});
    write_file(path, moving);
    const std::string first = run({"replay", path, "--digest"}).out;
    const std::string later = run({"replay", path, "--digest", "--frame", "48"}).out;
    EXPECT_NE(first.substr(0, first.size() - 2), later.substr(0, first.size() - 2));
    EXPECT_THAT(later, HasSubstr(",\"frame\":48}"));
    write_file(path, moving + first + later);
    EXPECT_EQ(run({"replay", path, "--check"}).status, Status::done);
    write_file(path, moving + first.substr(0, first.size() - 2) + ",\"frame\":48}\n");
    EXPECT_EQ(run({"replay", path, "--check"}).status, Status::check_failed);
}

TEST(Replay, SaysThatOnlyTheCausesDifferWhereTheResultIsTheSame)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text());
    std::string line = run({"replay", path, "--digest"}).out;
    line.replace(line.find(':') + 2, 32, std::string(32, '0'));
    write_file(path, scene_text() + line);
    EXPECT_THAT(run({"replay", path, "--check"}).talk, HasSubstr("the result's is the same"));
}

TEST(Replay, TakesTetrahedraAndTilesBeforeTheyGrowAsWhole)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    AddTetrahedra around;
    around.objects = {1};
    write_file(path, log_header() + command_line(AddBox{}) + command_line(around));
    const Ran ran = run({"replay", path, "--check"});
    EXPECT_EQ(ran.status, Status::done) << ran.talk;
}

TEST(Replay, NamesTheFirstLineThatDiffers)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    const std::string zeros(32, '0');
    write_file(path, scene_text() + check_line(zeros, "") + check_line("", zeros));
    const Ran ran = run({"replay", path, "--check"});
    EXPECT_EQ(ran.status, Status::check_failed);
    EXPECT_THAT(ran.talk, HasSubstr(path + ":5: the scene's digest differs"));
    EXPECT_THAT(ran.talk, Not(HasSubstr(path + ":6:")));
    EXPECT_EQ(run({"replay", path, "--check", "--to", "4"}).status, Status::done);
}

TEST(Replay, SaysWhatIsMissingAndFailsTheCheck)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    ImportModel import;
    import.file.path = "snail.obj";
    write_file(path, log_header() + command_line(import));
    const Ran ran = run({"replay", path});
    EXPECT_EQ(ran.status, Status::rejected);
    EXPECT_THAT(ran.talk, HasSubstr("snail.obj"));
    EXPECT_EQ(run({"replay", path, "--keep-going"}).status, Status::done);
    EXPECT_EQ(run({"replay", path, "--check"}).status, Status::check_failed);
}

TEST(Replay, RelinksFilesByName)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    ImportModel import;
    import.file.path = "models/triangle.obj";
    write_file(path, log_header() + command_line(import));
    write_file(folder.file("other.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Ran ran =
        run({"replay", path, "--set", "triangle.obj=" + folder.file("other.obj"), "--check"});
    EXPECT_EQ(ran.status, Status::done) << ran.talk;
    for (const char* wrong : {"circle.obj=other.obj", "triangle.obj=nowhere.obj"}) {
        const Ran refused = run({"replay", path, "--set", wrong});
        EXPECT_EQ(refused.status, Status::rejected);
        EXPECT_THAT(refused.talk, HasSubstr(wrong));
    }
}

TEST(Info, SaysTheClipsOfAModelByNameAndLength)
{
    const TemporaryFolder folder;
    write_file(folder.file("bar.gltf"),
               trivar::testing::gltf_text(trivar::testing::rigged_model()));
    const auto facts = nlohmann::json::parse(run({"info", folder.file("bar.gltf"), "--json"}).out);
    EXPECT_EQ(facts.at(0).at("clips").at(0).at("name"), "bend");
    EXPECT_EQ(facts.at(0).at("clips").at(0).at("seconds"), 1);
    EXPECT_THAT(run({"info", folder.file("bar.gltf")}).out, HasSubstr("bend (1 s), swell (1 s)"));
}

TEST(Replay, ExportsTheResultAndItsTimings)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text());
    const Ran ran = run({"replay", path, "--export", folder.file("a.obj"), folder.file("a.glb"),
                         "--timings", folder.file("t.json")});
    ASSERT_EQ(ran.status, Status::done) << ran.talk;
    EXPECT_THAT(ran.out, IsEmpty());
    for (const char* name : {"a.obj", "a.glb"}) {
        const Ran info = run({"info", folder.file(name), "--json"});
        ASSERT_EQ(info.status, Status::done) << info.talk;
        EXPECT_EQ(nlohmann::json::parse(info.out).at(0).at("kind"), "model");
    }
    const auto timings = nlohmann::json::parse(read_text_file(folder.file("t.json")));
    std::set<std::string> names;
    for (const auto& stage : timings.at("stages")) names.insert(stage.at("name"));
    for (const char* name : {"import", "rays", "springs", "lift", "volume", "deform"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Replay, DrawsAPictureWithoutADisplay)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, scene_text());
    const Ran ran = run({"replay", path, "--image", folder.file("a.png"), "--size", "160x90"});
    ASSERT_EQ(ran.status, Status::done) << ran.talk;
    const auto facts = nlohmann::json::parse(run({"info", folder.file("a.png"), "--json"}).out);
    EXPECT_EQ(facts.at(0).at("width_px"), 160);
    const Ran unknown = run({"replay", "/nowhere.trivar", "--image", "a.xyz"});
    EXPECT_EQ(unknown.status, Status::rejected);
    EXPECT_THAT(unknown.talk, HasSubstr("a.xyz: pictures cannot be written")); // before all work
    EXPECT_THAT(run({"replay", "/nowhere.trivar", "--export", "a.fbx"}).talk,
                HasSubstr("a.fbx: models are written"));
    EXPECT_EQ(run({"replay", path, "--image", folder.file("b.png"), "--camera", "moon"}).status,
              Status::rejected);
}

TEST(Replay, KeepsWhatAHandDidToTheDrawingThatItReplaces)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar"), svg = folder.file("a.svg");
    write_file(path, scene_text() + command_line(SetLineDrawing{{2}, {}}));
    const auto draw = [&] { return run({"replay", path, "--image", svg, "--size", "160x90"}); };
    ASSERT_EQ(draw().status, Status::done);
    std::string text = read_text_file(svg);
    const std::size_t line = text.find("<path id=");
    ASSERT_NE(line, text.npos);
    text.erase(line, text.find('\n', line) + 1 - line);
    text.insert(line, "<text x=\"9\" y='9'>lid</text><!-- mine -->\n");
    write_file(svg, text);
    const Ran again = draw();
    EXPECT_THAT(again.talk, HasSubstr("a.svg: 1 edit by hand was done again, 1 element of the "
                                      "hand's own kept"));
    EXPECT_EQ(read_text_file(svg), text);
    const std::string broken = text.substr(0, text.size() / 2);
    write_file(svg, broken);
    const Ran refused = draw();
    EXPECT_EQ(refused.status, Status::rejected);
    EXPECT_THAT(refused.talk, HasSubstr("delete it first"));
    EXPECT_EQ(read_text_file(svg), broken);
}

TEST(Info, DescribesVolumeData)
{
    const TemporaryFolder folder;
    VoxelGrid grid;
    grid.size = {6, 5, 4};
    std::vector<std::uint8_t> samples;
    for (int i = 0; i < 120; ++i) samples.push_back(i < 60 ? 10 : 200);
    grid.samples = samples;
    grid.to_metres = {{0.001, 0, 0, 0}, {0, 0.002, 0, 0}, {0, 0, 0.003, 0}, {0.01, 0.02, 0.03, 1}};
    write_file(folder.file("1.2.840"), write_nrrd(grid)); // known by its first bytes
    const auto facts =
        nlohmann::json::parse(run({"info", folder.file("1.2.840"), "--json"}).out)[0];
    EXPECT_EQ(facts.at("kind"), "volume data");
    EXPECT_EQ(facts.at("size"), nlohmann::json({6, 5, 4}));
    EXPECT_EQ(facts.at("type"), "unsigned 8-bit whole numbers");
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(facts.at("spacing_mm")[k], k + 1, 1e-9);
        EXPECT_NEAR(facts.at("origin_mm")[k], 10 * (k + 1), 1e-9);
        EXPECT_NEAR(facts.at("directions")[k][k], 1, 1e-9);
    }
    EXPECT_EQ(facts.at("range"), nlohmann::json({10, 200}));
    const double level = facts.at("suggested_levels")[0];
    EXPECT_GT(level, 10);
    EXPECT_LT(level, 200);
    EXPECT_THAT(run({"info", folder.file("1.2.840")}).out, HasSubstr("spacing mm       1, 2, 3\n"));
}

TEST(Info, NamesAllKindsOfFilesWhereOneIsNone)
{
    const TemporaryFolder folder;
    write_file(folder.file("notes"), "neither a mesh nor a picture");
    const Ran ran = run({"info", folder.file("notes")});
    EXPECT_EQ(ran.status, Status::rejected);
    for (const char* kind : {"a scene (.trivar)", "glTF", "NIfTI", "DICOM", "PNG"})
        EXPECT_THAT(ran.talk, HasSubstr(kind));
    std::filesystem::create_directory(folder.file("empty"));
    EXPECT_THAT(run({"info", folder.file("empty")}).talk,
                HasSubstr("no DICOM files and no pictures"));
}

TEST(Info, DescribesScenesAndGoesOnAfterAFileItCannotRead)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.trivar"), scene_text());
    const Ran ran = run({"info", folder.file("missing.obj"), folder.file("a.trivar")});
    EXPECT_EQ(ran.status, Status::rejected);
    EXPECT_THAT(ran.talk, HasSubstr("missing.obj"));
    EXPECT_THAT(ran.out, HasSubstr("scene"));
}

TEST(CommandLine, ReplayDrawsTheSameWhereverPlacedObjectsAreDeformed)
{
    const TemporaryFolder folder;
    write_file(folder.file("pot.trivar"), scene_text());
    std::vector<Image> images;
    for (const char* where : {"processor", "one_phase", "two_phases"}) {
        const std::string image = folder.file(std::string(where) + ".png");
        const Ran ran = run({"replay", folder.file("pot.trivar"), "--image", image, "--size",
                             "200x150", "--deform", where});
        ASSERT_EQ(ran.status, Status::done) << ran.talk;
        images.push_back(read_image(image));
    }
    for (const Image& image : images) {
        std::size_t off = 0;
        for (std::size_t i = 0; i < image.rgba.size(); ++i)
            off += std::abs(int{image.rgba[i]} - int{images.front().rgba[i]}) > 4;
        EXPECT_LT(off, image.rgba.size() / 2000);
    }
    EXPECT_EQ(run({"replay", folder.file("pot.trivar"), "--deform", "magic"}).status,
              Status::usage);
}

// With so few vertices only the device itself is measured.
TEST(CommandLine, BenchSaysWhatTheDeviceDoes)
{
    const Ran ran = run({"bench", "gpu", "--json", "--vertices", "1"});
    ASSERT_EQ(ran.status, Status::done) << ran.talk;
    const auto said = nlohmann::json::parse(ran.out);
    EXPECT_GT(said["copy_bytes_per_s"], 0);
    EXPECT_GT(said["multiply_adds_per_s"], 0);
    EXPECT_TRUE(said["rates"].empty());
    EXPECT_EQ(run({"bench"}).status, Status::usage);
    EXPECT_EQ(run({"bench", "chair"}).status, Status::usage);
}

} // namespace
} // namespace trivar
