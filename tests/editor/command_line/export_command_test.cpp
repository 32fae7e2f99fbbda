// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that move, exported and verified by the command line.
#include "core/base/text.h"
#include "core/commands/objects/play.h"
#include "core/files/gltf/glb_chunks.h"
#include "editor/command_line/command_line.h"
#include "editor/command_line/interrupts.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryFolder, testing::write_file;

class ExportCommand : public ::testing::Test {
protected:
    struct Told {
        Status status;
        std::string text;
    };
    ExportCommand()
    {
        SceneFile file = testing::typical_scene();
        file.save_as(scene_);
    }
    static Told run(const std::vector<std::string>& arguments)
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        return {status, out.str() + talk.str()};
    }
    Told exported(const std::string& to, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> all{"export", scene_, "--to", folder_.file(to)};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    }
    std::size_t files() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }
    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("scene.trivar");
};

TEST_F(ExportCommand, WritesAFileThatIsVerified)
{
    const Told told = exported("a.glb", {"--frames", "1:4", "--epsilon", "0.004"});
    EXPECT_EQ(told.status, Status::done) << told.text;
    EXPECT_THAT(told.text, HasSubstr("4 frames"));
    const Told verified = run({"verify", folder_.file("a.glb")});
    EXPECT_EQ(verified.status, Status::done) << verified.text;
    EXPECT_THAT(verified.text, HasSubstr("ten times the frame rate"));
    EXPECT_THAT(verified.text, HasSubstr("what it claims holds"));
}

// A deviation beyond the claim for a part is printed beside that claim.
TEST_F(ExportCommand, IsNeverSaidToHoldBesideAFigureThatIsBeyondItsClaim)
{
    write_file(folder_.file("bar.gltf"), testing::gltf_text(testing::rigged_model()));
    ImportModel bar;
    bar.file.path = "bar.gltf";
    bar.file.scale = 500; // what single precision leaves of it is seen
    write_file(scene_, log_header() + command_line(bar) +
                           command_line(PlayClip{{1}, {.clip = "bend", .speed = 1.3}}));
    ASSERT_EQ(exported("a.glb", {"--frames", "1:12"}).status, Status::done);
    const Told told = run({"verify", folder_.file("a.glb")});
    EXPECT_EQ(told.status, Status::done) << told.text;
    double off = 0, claimed = 0, there = 0, between = 0;
    const auto number_after = [&](const char* words) {
        const std::size_t at = told.text.find(words);
        EXPECT_NE(at, std::string::npos) << words << told.text;
        return std::strtod(told.text.c_str() + at + std::strlen(words), nullptr);
    };
    off = number_after("the furthest off by ");
    claimed = number_after("claimed: ");
    there = number_after(", where it is ");
    between = number_after(" m off at most, and ");
    EXPECT_GT(off, 0);
    EXPECT_LE(there, claimed) << told.text;
    EXPECT_LE(off, between) << told.text;
}

TEST_F(ExportCommand, IsFoundOutWhereAFileWasChanged)
{
    ASSERT_EQ(exported("a.glb", {"--frames", "1:3", "--epsilon", "0.004"}).status, Status::done);
    const std::string bytes = read_text_file(folder_.file("a.glb"));
    std::string claims = bytes;
    const std::size_t bound = claims.find("\"bound_m\":") + 10;
    claims[bound] = claims[bound] == '0' ? '1' : '0'; // another number of as many digits
    std::string data = bytes;                         // the last number of a key is another
    std::memset(data.data() + data.size() - 4, 0x3f, 4);
    for (const std::string& changed : {claims, data}) {
        write_file(folder_.file("a.glb"), changed);
        const Told told = run({"verify", folder_.file("a.glb")});
        EXPECT_TRUE(told.status == Status::check_failed || changed == claims) << told.text;
    }
}

TEST_F(ExportCommand, IsFoundOutWhereItsClaimsAreOfOtherParts)
{
    ASSERT_EQ(exported("a.glb", {"--frames", "1", "--epsilon", "0.004"}).status, Status::done);
    const GlbChunks whole = glb_chunks(read_text_file(folder_.file("a.glb")));
    const auto verified_with = [&](const std::function<void(nlohmann::json&)>& change) {
        GlbChunks chunks = whole;
        nlohmann::json file = nlohmann::json::parse(chunks.json);
        change(file["extras"]["trivar_animation"]);
        chunks.json = file.dump();
        write_file(folder_.file("a.glb"), glb_container(chunks));
        return run({"verify", folder_.file("a.glb")});
    };
    const Told none = verified_with([](auto&claims) { claims["parts"] = nlohmann::json::array(); }),
               fewer = verified_with([](auto&claims) { claims["parts"].erase(1); }),
               more = verified_with(
                   [](auto&claims) { claims["parts"].push_back(claims["parts"][0]); });
    EXPECT_THAT(none.text, HasSubstr("and it claims 0"));
    for (const Told& told : {none, fewer, more}) {
        EXPECT_EQ(told.status, Status::check_failed) << told.text;
        EXPECT_THAT(told.text, HasSubstr("parts: the scene gives 3 and it claims"));
    }
    const Told large = verified_with([](auto& claims) { claims["frames"][1] = 1e300; });
    EXPECT_EQ(large.status, Status::rejected);
    EXPECT_THAT(large.text, HasSubstr("not whole or is too large"));
    const Told loose = verified_with([](auto&claims) { claims["tolerance_m"] = 1e300; }),
               tight = verified_with([](auto&claims) { claims["tolerance_m"] = 1e-12; }),
               above = verified_with([](auto&claims) { claims["bound_m"] = 1; });
    EXPECT_EQ(loose.status, Status::rejected);
    EXPECT_THAT(loose.text, HasSubstr("is 1·10³⁰⁰ m, which proves nothing"));
    EXPECT_EQ(tight.status, Status::rejected);
    EXPECT_THAT(tight.text, HasSubstr("a.glb: the result that it claims cannot be exported"));
    EXPECT_EQ(above.status, Status::check_failed);
    EXPECT_THAT(above.text, HasSubstr("where the furthest of its parts claims"));
}

TEST(InterruptsDeathTest, OfOneAreWaitedForAndASecondEndsTheProgram)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto interrupted = [](int times, int signal) {
        std::signal(signal, SIG_DFL); // whatever this program was started to ignore
        const Interrupts interrupts;
        for (int i = 0; i < times; ++i) {
            ::kill(::getpid(), signal);
            while (!interrupts.came()) std::this_thread::yield();
        }
        if (times > 1) std::this_thread::sleep_for(std::chrono::minutes(5)); // as without an end
        std::_Exit(7);
    };
    EXPECT_EXIT(interrupted(1, SIGINT), ::testing::ExitedWithCode(7), "");
    EXPECT_EXIT(interrupted(2, SIGINT), ::testing::KilledBySignal(SIGINT), "");
    EXPECT_EXIT(interrupted(2, SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
    { // and one that nothing came to ends at once
        const Interrupts interrupts;
        EXPECT_FALSE(interrupts.came());
    }
}

TEST_F(ExportCommand, RefusesWhatCannotBeInASentence)
{
    const std::size_t before = files();
    const auto says = [&](const Told& told, Status status, const std::string& words) {
        EXPECT_EQ(told.status, status) << told.text;
        EXPECT_THAT(told.text, HasSubstr(words));
        EXPECT_EQ(std::count(told.text.begin(), told.text.end(), '\n'), 1) << told.text;
    };
    says(exported("a.glb", {"--frames", "0:4"}), Status::rejected, "frames are 1 to 240");
    says(exported("a.glb", {"--frames", "4:2"}), Status::usage,
         "the last frame comes before the first");
    says(exported("a.glb", {"--frames", "x"}), Status::usage, "such as 1:240");
    says(exported("a.glb", {"--epsilon", "0"}), Status::usage, "above 0");
    says(exported("a.glb", {"--epsilon", "-1"}), Status::usage, "above 0");
    says(exported("a.xyz"), Status::rejected, ".glb, .usda, .pc2 and .mdd");
    says(exported("nowhere/a.glb"), Status::rejected, "there is no folder");
    EXPECT_EQ(files(), before);
}

TEST_F(ExportCommand, StoppedByAnInterruptLeavesNothing)
{
    const std::string to = folder_.file("a.glb");
    std::vector<std::string> words{
        TRIVAR_BINARY_DIR "/trivar", "export", scene_, "--to", to, "--epsilon", "0.0005"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::size_t before = files();
    pid_t id = -1;
    ASSERT_EQ(::posix_spawn(&id, arguments[0], nullptr, nullptr, arguments.data(), environ), 0);
    // Until it waits for the signal: before that it simply ends, and leaves nothing either.
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ::kill(id, SIGINT);
    int status = 0;
    ::waitpid(id, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 130 || WEXITSTATUS(status) == 0);
    const bool done = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    EXPECT_EQ(files(), before + (done ? 1 : 0));
}

} // namespace
} // namespace trivar
