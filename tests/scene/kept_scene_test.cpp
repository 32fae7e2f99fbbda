// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/primitives.h"
#include "core/scene/scene_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/scene/kept_scenes.h"
#include "core/scene/log.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/full_disk.h"

#include <array>
#include <csignal>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar {
namespace {

using testing::FullDisk;
using ::testing::HasSubstr;
using testing::TemporaryFolder, testing::write_file;

TEST(KeptScene, KeepsTheFileWithATornLineBesideBeforeItGoesOn)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    const std::string whole = log_header() + command_line(AddBox{});
    const std::string torn = whole + "{\"do\":\"rena";
    write_file(path, torn);
    SceneFile scene(path);
    ASSERT_EQ(scene.notices().size(), 1u);
    EXPECT_EQ(read_text_file(path), torn); // looking changes nothing
    scene.run(AddSphere{});
    EXPECT_EQ(scene.trouble(), "");
    EXPECT_EQ(read_text_file(path), whole + command_line(AddSphere{}));
    EXPECT_EQ(read_text_file(path + ".torn"), torn);
}

TEST(KeptScene, GoesOnAfterALastLineWithoutABreak)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    const std::string whole = log_header() + command_line(AddBox{});
    write_file(path, whole.substr(0, whole.size() - 1));
    SceneFile(path).run(AddSphere{});
    EXPECT_EQ(read_text_file(path), whole + command_line(AddSphere{}));
}

TEST(KeptScene, SaysThatTheDiskIsFullAndCatchesUpLater)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    SceneFile scene;
    scene.run(AddBox{});
    scene.save_as(path);
    const std::string before = read_text_file(path);
    {
        const FullDisk full(before.size() + 10);
        scene.run(AddSphere{});
        EXPECT_THAT(scene.trouble(), HasSubstr("cannot be written"));
        EXPECT_EQ(read_text_file(path), before); // no half line
        EXPECT_EQ(scene.document().objects.size(), 2u);
    }
    scene.undo();
    EXPECT_EQ(scene.trouble(), "");
    EXPECT_EQ(read_text_file(path), before + command_line(AddSphere{}) + undo_line());
}

TEST(KeptScene, WritesWhatIsMissingAsSoonAsThereIsRoom)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar"), kept = folder.file("kept");
    SceneFile scene, unnamed;
    scene.run(AddBox{});
    scene.save_as(path);
    unnamed.keep_in(kept);
    {
        const FullDisk full(std::filesystem::file_size(path) + 10);
        scene.run(AddSphere{});
        scene.undo();
        scene.write_missing();
        EXPECT_THAT(scene.trouble(), HasSubstr("cannot be written"));
        unnamed.run(AddBox{});
        unnamed.run(AddSphere{});
        EXPECT_NE(unnamed.trouble(), "");
    }
    scene.write_missing();
    EXPECT_EQ(scene.trouble(), "");
    EXPECT_EQ(replay(read_log(read_text_file(path), path)).steps().size(), 2u);
    unnamed.write_missing();
    EXPECT_EQ(unnamed.trouble(), "");
    const std::string left = std::filesystem::directory_iterator(kept)->path().string();
    EXPECT_EQ(replay(read_log(read_text_file(left), left)).steps().size(), 2u);
}

TEST(KeptScene, LeavesThePreviousFileWhenSavingFails)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, "precious");
    SceneFile scene;
    scene.run(AddBox{});
    {
        const FullDisk full(20);
        EXPECT_THROW(scene.save_as(path), Rejected);
    }
    EXPECT_EQ(read_text_file(path), "precious");
    EXPECT_EQ(scene.path(), "");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    EXPECT_THROW(scene.save_as(folder.file("missing/a.trivar")), Rejected);
    EXPECT_THROW(scene.save_as(folder.path().string()), Rejected);
    EXPECT_THROW(scene.save_as("/dev/null"), Rejected);
}

TEST(KeptScene, NoticesThatItsFileWasTakenAway)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    SceneFile scene;
    scene.save_as(path);
    std::filesystem::remove(path);
    scene.run(AddBox{});
    EXPECT_THAT(scene.trouble(), HasSubstr("moved or deleted"));
    scene.save_as(path);
    EXPECT_EQ(scene.trouble(), "");
    EXPECT_EQ(read_text_file(path), log_header() + command_line(AddBox{}));
}

TEST(KeptScene, WithoutANameIsKeptFromItsFirstStepTillItHasOne)
{
    const TemporaryFolder folder;
    const std::string kept = folder.file("unnamed");
    SceneFile scene;
    scene.keep_in(kept);
    EXPECT_FALSE(SceneFile::left_in(kept));
    EXPECT_FALSE(std::filesystem::exists(kept)); // nothing was done yet
    scene.run(AddBox{});
    scene.run(AddSphere{});
    scene.undo();
    EXPECT_EQ(scene.path(), "");
    EXPECT_EQ(scene.trouble(), "");
    ASSERT_FALSE(std::filesystem::is_empty(kept));
    EXPECT_EQ(read_text_file(std::filesystem::directory_iterator(kept)->path().string()),
              log_header() + command_line(AddBox{}) + command_line(AddSphere{}) + undo_line());
    EXPECT_FALSE(SceneFile::left_in(kept)); // it is still open
    scene.save_as(folder.file("a.trivar"));
    EXPECT_TRUE(std::filesystem::is_empty(kept));
    EXPECT_EQ(SceneFile(folder.file("a.trivar")).history().steps().size(), 2u);
}

TEST(KeptScene, WithoutANameIsSetAsideTillItIsOldWhenItIsLetGo)
{
    const TemporaryFolder folder;
    const std::string kept = folder.path().string();
    SceneFile scene;
    scene.keep_in(kept);
    scene.run(AddBox{});
    for (int i = 0; i < 2; ++i) { // of one minute
        scene = SceneFile();
        scene.keep_in(kept);
        scene.run(AddBox{});
    }
    EXPECT_FALSE(SceneFile::left_in(kept)); // nobody lost it
    const std::vector<std::string> aside = SceneFile::set_aside_in(kept);
    ASSERT_EQ(aside.size(), 2u);
    EXPECT_EQ(SceneFile::copy_of(aside.front()).document().objects.size(), 1u);
    const auto age = [&](int days) {
        std::filesystem::last_write_time(
            aside.front(), std::filesystem::file_time_type::clock::now() - std::chrono::days(days));
        forget_old_scenes(kept, std::chrono::days(30));
        return SceneFile::set_aside_in(kept).size();
    };
    EXPECT_EQ(age(29), 2u);
    EXPECT_EQ(age(31), 1u);
}

TEST(KeptScene, ThatWasSetAsideIsKeptLikeAnyOtherWhenItIsTakenUpAgain)
{
    const TemporaryFolder folder;
    const std::string kept = folder.path().string();
    {
        SceneFile scene;
        scene.keep_in(kept);
        scene.run(AddBox{});
    }
    SceneFile scene = SceneFile::taken_up(SceneFile::set_aside_in(kept).front());
    EXPECT_TRUE(SceneFile::set_aside_in(kept).empty());
    scene.keep_in(kept);
    scene.run(AddSphere{});
    EXPECT_EQ(scene.trouble(), "");
    scene = SceneFile();
    ASSERT_EQ(SceneFile::set_aside_in(kept).size(), 1u);
    EXPECT_EQ(SceneFile::copy_of(SceneFile::set_aside_in(kept).front()).document().objects.size(),
              2u);
}

TEST(KeptScene, WithoutANameOutlivesAKilledProgram)
{
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        SceneFile scene;
        scene.keep_in(folder.path().string());
        scene.run(AddBox{});
        scene.run(AddSphere{});
        scene.undo();
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    const auto left = SceneFile::left_in(folder.path().string());
    ASSERT_TRUE(left);
    {
        SceneFile scene = SceneFile::taken_up(*left);
        scene.keep_in(folder.path().string()); // as it is already
        EXPECT_EQ(scene.path(), "");
        EXPECT_EQ(scene.document().objects.size(), 1u);
        EXPECT_TRUE(scene.redo());
        EXPECT_FALSE(SceneFile::left_in(folder.path().string()));
    }
    EXPECT_FALSE(SceneFile::left_in(folder.path().string()));
}

// Has the scene open and so much memory that it takes a while to go when it is killed.
pid_t large_program_with(const std::function<SceneFile()>& open)
{
    std::array<int, 2> ready{};
    EXPECT_EQ(::pipe(ready.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const SceneFile scene = open();
        const std::vector<char> memory(std::size_t{1} << 28, 'x');
        if (::write(ready[1], memory.data(), 1) != 1) ::_exit(1);
        for (;;) ::pause();
    }
    char c = 0;
    EXPECT_EQ(::read(ready[0], &c, 1), 1);
    for (const int end : ready) ::close(end);
    return child;
}

TEST(KeptScene, IsOpenedWithItsNameWhileAKilledProgramStillGivesBackItsMemory)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    write_file(path, log_header() + command_line(AddBox{}));
    const pid_t killed = large_program_with([&] { return SceneFile(path); });
    EXPECT_TRUE(SceneFile(path).in_use()); // nobody waits for who is alive
    ::kill(killed, SIGKILL);
    const SceneFile scene(path);
    EXPECT_EQ(scene.path(), path);
    EXPECT_FALSE(scene.in_use());
    ::waitpid(killed, nullptr, 0);
}

TEST(KeptScene, WithoutANameIsFoundWhileAKilledProgramStillGivesBackItsMemory)
{
    const TemporaryFolder folder;
    const std::string kept = folder.path().string();
    const pid_t killed = large_program_with([&] {
        SceneFile scene;
        scene.keep_in(kept);
        scene.run(AddBox{});
        return scene;
    });
    EXPECT_FALSE(SceneFile::left_in(kept));
    ::kill(killed, SIGKILL);
    EXPECT_TRUE(SceneFile::left_in(kept));
    ::waitpid(killed, nullptr, 0);
}

TEST(KeptScene, SaysWhyItIsNotKept)
{
    SceneFile scene;
    scene.keep_in("/proc/nowhere");
    scene.run(AddBox{});
    EXPECT_THAT(scene.trouble(), HasSubstr("cannot be written"));
    EXPECT_EQ(scene.document().objects.size(), 1u);
}

} // namespace
} // namespace trivar
