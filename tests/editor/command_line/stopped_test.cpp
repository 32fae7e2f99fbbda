// SPDX-License-Identifier: GPL-3.0-or-later
// Signals that come while the program works: what it writes is whole or not there.
#include "core/base/text.h"
#include "core/commands/objects/primitives.h"
#include "core/files/read_model.h"
#include "core/scene/log.h"
#include "editor/command_line/interrupts.h"
#include "tests/support/fixtures.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

// Runs the program and sends it a signal after some time; how it ended.
int status_after(std::vector<std::string> words, int signal, milliseconds after)
{
    words.insert(words.begin(), TRIVAR_BINARY_DIR "/trivar");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawnattr_t usual; // whatever this program was started to ignore
    posix_spawnattr_init(&usual);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigdefault(&usual, &all);
    posix_spawnattr_setflags(&usual, POSIX_SPAWN_SETSIGDEF);
    pid_t id = -1;
    EXPECT_EQ(::posix_spawn(&id, arguments[0], nullptr, &usual, arguments.data(), environ), 0);
    posix_spawnattr_destroy(&usual);
    std::this_thread::sleep_for(after);
    ::kill(id, signal);
    int status = 0;
    ::waitpid(id, &status, 0);
    return status;
}

class Stopped : public ::testing::TestWithParam<int> {
protected:
    Stopped()
    {
        AddSphere ball;
        ball.shape.segments = 512;
        ball.shape.rings = 512;
        testing::write_file(scene, log_header() + command_line(ball));
    }
    // The scene, and files that are whole.
    void expect_nothing_is_half_done() const
    {
        for (const auto& each : fs::directory_iterator(folder.path())) {
            const std::string name = each.path().filename().string();
            if (name == "a.trivar" || name == "out.mtl") continue;
            ASSERT_TRUE(name == "out.glb" || name == "out.obj" || name == "out.usda") << name;
            const std::string path = each.path().string();
            const bool whole = name == "out.usda" ? read_text_file(path).ends_with("}\n")
                                                  : !read_model(path).meshes.empty();
            EXPECT_TRUE(whole) << name;
        }
    }
    testing::TemporaryFolder folder;
    const std::string scene = folder.file("a.trivar");
};

TEST_P(Stopped, LeavesOnlyWholeFiles)
{
    for (const int after_ms : {60, 250, 500, 900}) {
        for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
                 {"replay", scene, "--export", folder.file("out.glb"), folder.file("out.obj")},
                 {"export", scene, "--frames", "1:9", "--to", folder.file("out.usda")}}) {
            const int status = status_after(words, GetParam(), milliseconds(after_ms));
            EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 130 ||
                        WEXITSTATUS(status) == 0)
                << words[0] << " ended with " << WEXITSTATUS(status);
            expect_nothing_is_half_done();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BySignals, Stopped, ::testing::Values(SIGINT, SIGTERM, SIGHUP, SIGKILL));

TEST(InterruptsDeathTest, AreNotOfSignalsThatTheProgramWasStartedToIgnore)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto hung_up = [] {
        std::signal(SIGHUP, SIG_IGN); // as nohup does
        const Interrupts interrupts;
        ::kill(::getpid(), SIGHUP);
        std::this_thread::sleep_for(milliseconds(50));
        std::_Exit(interrupts.came() ? 1 : 7);
    };
    EXPECT_EXIT(hung_up(), ::testing::ExitedWithCode(7), "");
    const auto hung_up_as_usual = [] {
        std::signal(SIGHUP, SIG_DFL);
        const Interrupts interrupts;
        ::kill(::getpid(), SIGHUP);
        while (!interrupts.came()) std::this_thread::yield();
        std::_Exit(7);
    };
    EXPECT_EXIT(hung_up_as_usual(), ::testing::ExitedWithCode(7), "");
}

} // namespace
} // namespace trivar
