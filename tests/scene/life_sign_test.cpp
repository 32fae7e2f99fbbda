// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/primitives.h"
#include "core/scene/life_sign.h"

#include "core/scene/kept_scenes.h"
#include "core/scene/log.h"
#include "core/scene/scene_file.h"
#include "tests/support/dying.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::SizeIs;

struct LifeSigns : ::testing::Test {
    testing::TemporaryFolder home;
    const std::string folder = home.path().string();
    std::size_t too_many(std::size_t lines) const
    {
        return LifeSign(folder, "/a.trivar", lines).steps_too_many();
    }
    void die(std::size_t lines, bool at_work) const
    {
        testing::die_with([&] {
            static LifeSign sign(folder, "/a.trivar", lines);
            sign.follow(lines, at_work);
        });
    }
    std::size_t files() const
    {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder), {}));
    }
};

TEST_F(LifeSigns, OfTwoProgramsThatEndedAtWorkAreOneStepTooMany)
{
    EXPECT_EQ(too_many(5), 0u);
    die(5, true);
    {
        const LifeSign sign(folder, "/a.trivar", 5);
        EXPECT_EQ(sign.steps_too_many(), 0u) << "one may have been killed";
    }
    // That one ended well
    die(5, true);
    die(5, true);
    EXPECT_EQ(LifeSign(folder, "/b.trivar", 5).steps_too_many(), 0u) << "another scene";
    EXPECT_EQ(too_many(5), 1u);
}

TEST_F(LifeSigns, OfProgramsThatAreKilledWhileTheyWaitSayNothing)
{
    for (int i = 0; i < 4; ++i) die(5, false);
    EXPECT_EQ(too_many(5), 0u);
}

TEST_F(LifeSigns, OfAnotherStateSayNothing)
{
    die(5, true);
    die(6, true);
    EXPECT_EQ(too_many(6), 0u);
    EXPECT_EQ(files(), 0u) << "who ends well leaves no sign";
}

// However deep the step lies that ends the programs, few of them find it.
TEST_F(LifeSigns, OfStepsThatWereTakenBackAskForMoreAndMore)
{
    die(100, true);
    die(100, true);
    std::size_t lines = 100;
    for (const std::size_t wanted : {1u, 2u, 4u, 8u}) {
        testing::die_with([&] {
            static LifeSign sign(folder, "/a.trivar", lines);
            if (sign.steps_too_many() != wanted) ::_exit(1); // leaves a sign of no further round
            sign.take_back(lines + wanted);
            sign.follow(lines + wanted, true);
        });
        lines += wanted;
    }
    EXPECT_EQ(too_many(lines), 16u);
}

TEST_F(LifeSigns, BelongToTheProgramThatLives)
{
    LifeSign living(folder, "/a.trivar", 5);
    living.follow(5, true);
    EXPECT_EQ(too_many(5), 0u);
    EXPECT_EQ(files(), 1u) << "the other's stays";
}

TEST_F(LifeSigns, AreDoneWithoutWhereNoneCanBeWritten)
{
    const std::string file = home.file("no folder");
    testing::write_file(file, "");
    for (const std::string& nowhere : {std::string(), file}) {
        LifeSign sign(nowhere, "/a.trivar", 5);
        sign.follow(6, true);
        EXPECT_EQ(sign.steps_too_many(), 0u);
    }
}

TEST_F(LifeSigns, ThatAreDamagedSayNothing)
{
    {
        const LifeSign sign(folder, "/a.trivar", 5);
        for (const auto& each : std::filesystem::directory_iterator(folder))
            testing::write_file(each.path(), "5 yes");
    }
    EXPECT_EQ(too_many(5), 0u);
}

TEST_F(LifeSigns, OfLongAgoAreRemovedWithOldScenes)
{
    die(5, true);
    forget_old_scenes(folder, std::chrono::hours(1));
    EXPECT_EQ(files(), 1u);
    for (const auto& each : std::filesystem::directory_iterator(folder))
        std::filesystem::last_write_time(
            each.path(), std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
    forget_old_scenes(folder, std::chrono::hours(1));
    EXPECT_EQ(files(), 0u);
}

TEST_F(LifeSigns, OfASceneThatEndedItsReadersSetItAside)
{
    const std::string left = home.file("untitled-1.trivar");
    testing::write_file(left, log_header() + command_line(AddBox{}));
    EXPECT_EQ(SceneFile::left_in(folder), left);
    for (int i = 0; i < 2; ++i)
        testing::die_with([&] { static LifeSign sign(folder, left + reading_sign, 0, true); });
    EXPECT_EQ(SceneFile::left_in(folder), std::nullopt);
    EXPECT_THAT(SceneFile::set_aside_in(folder), SizeIs(1));
}

TEST(CopiedScene, CanDoWithoutItsLastLines)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("a.trivar");
    testing::write_file(path, log_header() + command_line(AddBox{}) + command_line(AddSphere{}));
    const SceneFile copy = SceneFile::copy_of(path, 1);
    EXPECT_EQ(copy.history().steps().size(), 1u);
    ASSERT_THAT(copy.notices(), SizeIs(1));
    EXPECT_THAT(copy.notices().front(), HasSubstr("without its last line"));
    EXPECT_EQ(SceneFile::copy_of(path, 100).history().steps().size(), 0u);
    EXPECT_EQ(SceneFile(path).history().steps().size(), 2u);
}

} // namespace
} // namespace trivar
