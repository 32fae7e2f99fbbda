// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences of pictures by the command line.
#include "core/base/text.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/text.h"
#include "core/files/pictures/image.h"
#include "editor/command_line/command_line.h"
#include "editor/record/sequence.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <numeric>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr, ::testing::IsEmpty;
using testing::TemporaryFolder, testing::write_file;

struct Told {
    Status status;
    std::string out, talk;
};

// A box that travels on a plane, in frames of 64 x 36 pixels.
struct Sequences : ::testing::Test {
    TemporaryFolder folder;
    const std::string scene = folder.file("scene.trivar");
    Sequences()
    {
        SceneFile file = testing::typical_scene();
        file.save_as(scene);
    }
    std::vector<std::string> arguments(const std::string& out,
                                       const std::vector<std::string>& more = {},
                                       const std::string& frames = "1:12") const
    {
        std::vector<std::string> all{"render", scene,    "--frames", frames,      "--out",
                                     out,      "--size", "64x36",    "--quality", "draft"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    static Told run(const std::vector<std::string>& arguments)
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        return {status, out.str(), talk.str()};
    }
    Told render(const std::string& name, const std::vector<std::string>& more = {},
                const std::string& frames = "1:12") const
    {
        return run(arguments(folder.file(name), more, frames));
    }
    // Returns the pictures that are whole, by name.
    std::map<std::string, std::string> files(const std::string& name) const
    {
        std::map<std::string, std::string> out;
        for (const auto& entry : fs::directory_iterator(folder.file(name)))
            if (const std::string extension = entry.path().extension();
                extension == ".png" || extension == ".exr")
                out[entry.path().filename()] = read_text_file(entry.path());
        return out;
    }
};

// The built program, apart.
struct Program {
    explicit Program(const std::vector<std::string>& arguments)
        : Program(TRIVAR_BINARY_DIR "/trivar", arguments)
    {
    }
    Program(const std::string& program, std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), program);
        std::vector<char*> words;
        for (std::string& word : arguments) words.push_back(word.data());
        words.push_back(nullptr);
        EXPECT_EQ(::posix_spawn(&id, words.front(), nullptr, nullptr, words.data(), environ), 0);
    }
    int end() const // its wait status
    {
        int status = 0;
        ::waitpid(id, &status, 0);
        return status;
    }
    pid_t id = -1;
};

void wait_for(const std::string& file)
{
    using namespace std::chrono_literals;
    for (int i = 0; i < 6000 && !fs::exists(file); ++i) std::this_thread::sleep_for(5ms);
}

TEST_F(Sequences, AreTheSameBytesWholeInSharesAndAfterBeingKilledAndResumed)
{
    const auto all = [&](const std::string& name, const std::vector<std::string>& more = {}) {
        return render(name, more, "1:240");
    };
    ASSERT_EQ(all("whole/a.####.png").status, Status::done);
    const auto whole = files("whole");
    ASSERT_EQ(whole.size(), 240u);
    for (const std::string shard : {"1/4", "2/4", "3/4", "4/4"})
        ASSERT_EQ(all("shares/a.####.png", {"--shard", shard}).status, Status::done);
    EXPECT_TRUE(files("shares") == whole);
    const Program killed(arguments(folder.file("resumed/a.####.png"), {}, "1:240"));
    wait_for(folder.file("resumed/a.0060.png"));
    ::kill(killed.id, SIGKILL);
    const int status = killed.end();
    ASSERT_TRUE(WIFSIGNALED(status));
    const auto left = files("resumed");
    EXPECT_THAT(left.size(), ::testing::AllOf(::testing::Ge(60u), ::testing::Lt(240u)));
    for (const auto& [name, bytes] : left) EXPECT_TRUE(bytes == whole.at(name)) << name;
    write_file(folder.file("resumed/a.0239.png.Xy12Zw"), "half of it"); // as a kill leaves it
    const Told told = all("resumed/a.####.png", {"--resume"});
    EXPECT_EQ(told.status, Status::done);
    EXPECT_THAT(told.talk, HasSubstr(fmt::format("240 frames, {} drawn", 240 - left.size())));
    EXPECT_TRUE(files("resumed") == whole);
}

TEST_F(Sequences, AreThePicturesThatReplayDraws)
{
    ASSERT_EQ(render("a.#.png", {}, "1:9:4").status, Status::done);
    ASSERT_TRUE(fs::exists(folder.file("a.5.png")) && fs::exists(folder.file("a.9.png")));
    for (const std::string frame : {"1", "9"}) { // the first also decides where all look from
        KeepView camera{"picture", {}};
        camera.camera.eye = {0.5, -6, 4};
        camera.camera.target = {};
        SceneFile file(scene);
        file.run(camera);
        file.save_as(folder.file("seen.trivar"));
        const std::string seen = folder.file("seen.trivar"), picture = folder.file("r.png");
        ASSERT_EQ(
            run({"replay", seen, "--frame", frame, "--image", picture, "--size", "64x36"}).status,
            Status::done);
        ASSERT_EQ(run({"render", seen, "--frames", frame, "--size", "64x36", "--out",
                       folder.file("s.#.png")})
                      .status,
                  Status::done);
        EXPECT_EQ(read_image(picture).rgba, read_image(folder.file("s." + frame + ".png")).rgba);
    }
}

TEST_F(Sequences, AreResumedWhereAFileIsWholeAndOneOfThem)
{
    const auto resume = [&](std::vector<std::string> more) {
        more.emplace_back("--resume");
        const Told told = render("a.####.png", more, "1:3");
        EXPECT_EQ(told.status, Status::done) << told.talk;
        return told.talk;
    };
    EXPECT_THAT(resume({}), HasSubstr("3 frames, 3 drawn"));
    EXPECT_THAT(resume({}), HasSubstr("3 frames, 0 drawn"));
    const auto whole = files(".");
    fs::resize_file(folder.file("a.0002.png"), fs::file_size(folder.file("a.0002.png")) / 2);
    fs::copy_file(folder.file("a.0001.png"), folder.file("a.0003.png"),
                  fs::copy_options::overwrite_existing);
    EXPECT_THAT(resume({}), HasSubstr("2 drawn"));
    EXPECT_EQ(files("."), whole);
    write_file(folder.file("a.0001.png"), "no picture");
    EXPECT_THAT(resume({}), HasSubstr("1 drawn"));
    EXPECT_THAT(resume({"--depth", "16"}), HasSubstr("3 drawn"));
    EXPECT_THAT(resume({}), HasSubstr("3 drawn"));
    EXPECT_THAT(resume({"--deform", "two_phases"}), HasSubstr("3 drawn"));
    {
        SceneFile file(scene);
        file.run(SetTransform{1, {.translation = {0, 0, 0.1}}});
    }
    EXPECT_THAT(resume({}), HasSubstr("3 drawn"));
}

TEST_F(Sequences, SayWhichLogAndFrameTheyAre)
{
    ASSERT_EQ(render("a.##.png", {}, "7").status, Status::done);
    ASSERT_EQ(render("d.##.png", {"--depth", "16"}, "7").status, Status::done);
    ASSERT_EQ(render("a.##.exr", {}, "7").status, Status::done);
    const std::string log = digest_of_log(read_text_file(scene));
    for (const auto& [name, bits] :
         std::map<std::string, int>{{"a.07.png", 8}, {"d.07.png", 16}, {"a.07.exr", 16}}) {
        const ImageHead head =
            PictureReader().head(folder.file(name), {"trivar:log", "trivar:frame"});
        EXPECT_EQ(head.tags, (ImageTags{{"trivar:log", log}, {"trivar:frame", "7"}})) << name;
        EXPECT_EQ(head.bits, bits) << name;
        EXPECT_EQ(head.size_px, glm::ivec2(64, 36)) << name;
    }
    // EXR is linear light, read back as what is shown.
    const Image eight = read_image(folder.file("a.07.png")),
                linear = read_image(folder.file("a.07.exr"));
    for (std::size_t i = 0; i < eight.rgba.size(); ++i)
        ASSERT_NEAR(eight.rgba[i], linear.rgba[i], 4) << i;
}

TEST_F(Sequences, RefuseInASentenceWhatMakesNone)
{
    const std::string good = folder.file("a.####.png");
    const auto refused = [&](const std::vector<std::string>& all, const std::string& why,
                             Status status = Status::rejected) {
        const Told told = run(all);
        EXPECT_EQ(told.status, status) << why;
        EXPECT_THAT(told.out, IsEmpty());
        EXPECT_THAT(told.talk, HasSubstr(why));
        EXPECT_EQ(std::ranges::count(told.talk, '\n'), 1) << told.talk;
    };
    for (const char* frames :
         {"", "a", "1:", ":", "1:2:3:4", "1:2:0", "5:1", "1-5", "1:9:-1", "99999999999", "1 :2"})
        refused(arguments(good, {}, frames), "--frames", Status::usage);
    refused(arguments(good, {}, "-2000000000:2000000000"), "more than", Status::usage);
    refused(arguments(good, {}, "200:300"), "the scene has no frame 241; its frames are 1 to 240");
    refused(arguments(good, {}, "0:3"), "no frame 0");
    for (const char* shard : {"0/4", "5/4", "1", "1/0", "-1/4", "1/4/2", "x/y", "1/4x", "/"})
        refused(arguments(good, {"--shard", shard}), "--shard", Status::usage);
    refused(arguments(folder.file("a.png")), "needs ####", Status::usage);
    refused(arguments(folder.file("a#b/c.png")), "needs ####", Status::usage);
    refused(arguments(folder.file("a.##.##.png")), "stand together", Status::usage);
    refused(arguments(folder.file("a.####.jpg")), ".png or .exr", Status::usage);
    refused(arguments(folder.file("a.####")), ".png or .exr", Status::usage);
    refused(arguments(folder.file("a.####.exr"), {"--depth", "16"}), "--depth", Status::usage);
    for (const char* sheet : {"3", "0x2", "3x-2", "3x2x1"})
        refused(arguments(folder.file("a.png"), {"--sheet", sheet}), "--sheet", Status::usage);
    refused(arguments(folder.file("none/none/a.####.png")), "the folder does not exist");
    refused(arguments(scene + "/a.####.png"), "the folder does not exist");
    refused(arguments(good, {"--video", folder.file("a.gif")}), ".mp4, .mov or .mkv");
    refused(arguments(folder.file("new/a.####.png"), {"--camera", "nobody"}),
            "no bookmark of that name");
    EXPECT_THAT(render("a.####.png", {"--depth", "12"}).status, Status::usage);
    EXPECT_THAT(files("."), IsEmpty());
}

TEST_F(Sequences, EndInASentenceWhereTheFolderIsFullOrGoes)
{
    // A limit of the system stands for a disk that is full: half a kilobyte a file.
    const std::string limited = "ulimit -f 1; exec \"$0\" \"$@\" 2> " + folder.file("said.txt");
    std::vector<std::string> words{"-c", limited, TRIVAR_BINARY_DIR "/trivar"};
    for (const std::string& word : arguments(folder.file("full/a.####.png"))) words.push_back(word);
    const int full = Program("/bin/sh", words).end();
    ASSERT_TRUE(WIFEXITED(full));
    EXPECT_EQ(WEXITSTATUS(full), 1);
    EXPECT_THAT(read_text_file(folder.file("said.txt")),
                HasSubstr("a.0001.png: cannot be written"));
    EXPECT_TRUE(fs::is_empty(folder.file("full")));

    const Program program(arguments(folder.file("gone/a.####.png"), {}, "1:240"));
    wait_for(folder.file("gone/a.0002.png"));
    fs::rename(folder.file("gone"), folder.file("away"));
    const int status = program.end();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);

    const Program robbed(arguments(folder.file("robbed/a.####.png"), {}, "1:120"));
    wait_for(folder.file("robbed/a.0002.png"));
    fs::remove(folder.file("robbed/a.0001.png"));
    EXPECT_EQ(WEXITSTATUS(robbed.end()), 1);
    EXPECT_EQ(files("robbed").size(), 119u);
}

TEST_F(Sequences, EndAfterTheFrameAtHandWhenInterrupted)
{
    const Program program(arguments(folder.file("a/a.####.png"), {}, "1:240"));
    wait_for(folder.file("a/a.0002.png"));
    ::kill(program.id, SIGINT);
    const int status = program.end();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    const auto pictures = files("a");
    EXPECT_LT(pictures.size(), 240u);
    EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.file("a")), {})),
              pictures.size()); // nothing else
    for (const auto& [name, bytes] : pictures)
        EXPECT_NO_THROW(PictureReader().head(folder.file("a/" + name), {})) << name;
}

TEST_F(Sequences, LookAsKeysHaveItInEachFrameAndWantAllFilesOfTheScene)
{
    SceneFile file(scene);
    Track light;
    light.parameter = "render.exposure";
    light.keys = {{.frame = 1, .value = 0}, {.frame = 12, .value = 3}};
    file.run(Animate{{{0, {light}}}});
    file.save_as(scene);
    ASSERT_EQ(render("lit/a.##.png", {}, "1:12:11").status, Status::done);
    const Image dark = read_image(folder.file("lit/a.01.png")),
                bright = read_image(folder.file("lit/a.12.png"));
    const auto sum = [](const Image& image) {
        return std::accumulate(image.rgba.begin(), image.rgba.end(), 0L);
    };
    EXPECT_GT(sum(bright), sum(dark) + 64 * 36);

    ImportModel gone;
    gone.file.path = "gone.obj";
    gone.name = "Gone";
    file.run(gone);
    const Told told = render("none/a.##.png");
    EXPECT_EQ(told.status, Status::rejected);
    EXPECT_THAT(told.talk, HasSubstr("gone.obj: there is no such file"));
    EXPECT_FALSE(fs::exists(folder.file("none")));
}

// A program of that name, before all others.
struct SomeFfmpeg {
    SomeFfmpeg(const TemporaryFolder& folder, const std::string& script)
    {
        write_file(folder.file("bin/ffmpeg"), "#!/bin/sh\n" + script);
        fs::permissions(folder.file("bin/ffmpeg"), fs::perms::owner_all);
        ::setenv("PATH", (folder.file("bin") + ":" + before).c_str(), 1);
    }
    ~SomeFfmpeg() { ::setenv("PATH", before.c_str(), 1); }
    const std::string before = std::getenv("PATH");
};

TEST_F(Sequences, BecomeAVideoWhenAllFramesAreThere)
{
    const std::string video = folder.file("a video.mp4");
    {
        const SomeFfmpeg takes_all(folder, "for last; do :; done; exec cat > \"$last\"\n");
        const Told half = render("v/a.#.png", {"--shard", "1/2", "--video", video}, "1:7:2");
        EXPECT_EQ(half.status, Status::done);
        EXPECT_THAT(half.talk, HasSubstr("2 of 4 are not"));
        EXPECT_FALSE(fs::exists(video));
        const Told all = render("v/a.#.png", {"--resume", "--video", video}, "1:7:2");
        EXPECT_EQ(all.status, Status::done) << all.talk;
    }
    std::string one_after_another;
    for (const auto& [name, bytes] : files("v")) one_after_another += bytes;
    EXPECT_EQ(read_text_file(video), one_after_another);
    fs::remove(video);
    for (const char* script : {"exit 1\n", "exit 0\n", "cat > /dev/null; exit 1\n"}) {
        const SomeFfmpeg fails(folder, script);
        const Told told = render("v/a.#.png", {"--resume", "--video", video}, "1:7:2");
        EXPECT_EQ(told.status, Status::rejected);
        EXPECT_THAT(told.talk, HasSubstr("ffmpeg could not make it"));
        EXPECT_FALSE(fs::exists(video));
    }
}

TEST_F(Sequences, LeaveNoVideoWhereThatIsInterrupted)
{
    const SomeFfmpeg takes_its_time(folder, "echo > \"$0.begun\"\nexec sleep 600\n");
    const std::string out = folder.file("v/a.####.png");
    ASSERT_EQ(render("v/a.####.png", {}, "1:240").status, Status::done); // more than a pipe holds
    const Program program(arguments(out, {"--resume", "--video", folder.file("v.mp4")}, "1:240"));
    while (!fs::exists(folder.file("bin/ffmpeg.begun")))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(program.id, SIGTERM);
    const int status = program.end();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    for (const auto& each : fs::directory_iterator(folder.path()))
        EXPECT_FALSE(each.path().filename().string().starts_with("v.mp4")) << each.path();
}

TEST_F(Sequences, AreDrawnAnewWhereAFileOfTheirsIsAnother)
{
    const std::string mtl = folder.file("tri.mtl");
    write_file(folder.file("tri.obj"),
               "mtllib tri.mtl\nv 0 0 0\nv 1 0 0\nv 0 0 1\nusemtl a\nf 1 2 3\n");
    write_file(mtl, "newmtl a\nKd 1 0 0\n");
    SceneFile file(scene);
    ImportModel model;
    model.file.path = folder.file("tri.obj");
    file.run(model);
    file.save_as(scene);
    ASSERT_EQ(render("m/a.#.png", {}, "1").status, Status::done);
    const auto red = files("m");
    EXPECT_THAT(render("m/a.#.png", {"--resume"}, "1").talk, HasSubstr("1 frame, 0 drawn"));
    write_file(mtl, "newmtl a\nKd 0 0 1\n");
    EXPECT_THAT(render("m/a.#.png", {"--resume"}, "1").talk, HasSubstr("1 frame, 1 drawn"));
    EXPECT_NE(files("m"), red);
}

TEST(SequenceSettings, TellADevelopersShadersAndTheFontThatIsThere)
{
    const AssetStore assets("");
    const auto of_font = [&](const std::string& name) {
        SceneFile file;
        AddText text;
        text.shape.font = name;
        file.run(text);
        return sequence_settings("", file.document(), assets);
    };
    EXPECT_THAT(of_font("DejaVu Sans"), HasSubstr(" files="));
    EXPECT_NE(of_font("DejaVu Sans"), of_font("DejaVu Serif"));
    const auto of_shaders = [&](const std::string& text) {
        return sequence_settings("", {}, assets,
                                 make_ref(gpu::ShaderTexts{{"sky.frag.glsl", text}}));
    };
    EXPECT_NE(of_shaders("a"), of_shaders("b"));
    EXPECT_NE(of_shaders("a"), sequence_settings("", {}, assets));
}

TEST(TimeLeft, IsWhatTheOnesBeforeTook)
{
    EXPECT_EQ(time_left(0, 10, 0), "");
    EXPECT_EQ(time_left(1, 10, 2), "18 s left");
    EXPECT_EQ(time_left(1, 10, 40), "6 min left");
    EXPECT_EQ(time_left(1, 10, 1000), "2.5 h left");
    EXPECT_EQ(time_left(10, 10, 40), "");
}

} // namespace
} // namespace trivar
