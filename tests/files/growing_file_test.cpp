// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/growing_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "tests/support/fixtures.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::ThrowsMessage;
using testing::TemporaryFolder, testing::write_file;

std::vector<std::string> names_in(const TemporaryFolder& folder)
{
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(folder.path()))
        names.push_back(each.path().filename().string());
    std::ranges::sort(names);
    return names;
}

bool is_unnamed(const GrowingFile& file)
{
    return file.for_others().starts_with("/proc/");
}

TEST(GrowingFile, HasItsNameWhenItIsWholeAndNotBefore)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.bin");
    for (const std::string text : {"first", "second"}) {
        GrowingFile file(path);
        file.append(text);
        EXPECT_TRUE(!fs::exists(path) || read_text_file(path) == "first");
        file.finish();
        EXPECT_EQ(read_text_file(path), text);
        EXPECT_THAT(names_in(folder), ElementsAre("a.bin"));
    }
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0644));
}

TEST(GrowingFile, LeavesNothingWhereItIsNotFinished)
{
    const TemporaryFolder folder;
    write_file(folder.file("a.bin"), "before");
    for (const bool closed : {false, true}) {
        GrowingFile file(folder.file("a.bin"));
        file.append("half");
        if (closed) file.close();
    }
    EXPECT_THAT(names_in(folder), ElementsAre("a.bin"));
    EXPECT_EQ(read_text_file(folder.file("a.bin")), "before");
}

TEST(GrowingFileDeathTest, LeavesNothingWhereTheProgramIsKilled)
{
    const TemporaryFolder folder;
    if (!is_unnamed(GrowingFile(folder.file("a.bin"))))
        GTEST_SKIP() << "this file system knows no files without a name";
    const auto killed_before_its_end = [&] {
        GrowingFile file(folder.file("a.bin"));
        file.append(std::string(std::size_t{3} << 20, 'a'));
        file.settle();
        std::raise(SIGKILL);
    };
    EXPECT_EXIT(killed_before_its_end(), ::testing::KilledBySignal(SIGKILL), "");
    EXPECT_THAT(names_in(folder), ElementsAre());
}

TEST(GrowingFile, IsFilledByOthersToo)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.bin");
    for (const std::string text : {"first", "second"}) {
        GrowingFile file(path);
        std::ofstream(file.for_others()) << text; // which cuts it first, as other programs do
        EXPECT_EQ(fs::file_size(file.for_others()), text.size());
        file.finish();
        EXPECT_EQ(read_text_file(path), text);
    }
}

TEST(GrowingFile, CanBeClosedAndFinishedLater)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("a.bin");
    for (const std::string text : {"first", "second"}) {
        GrowingFile file(path);
        file.append(text);
        file.close();
        file.finish();
        EXPECT_EQ(read_text_file(path), text);
        EXPECT_THAT(names_in(folder), ElementsAre("a.bin"));
    }
}

TEST(GrowingFile, TakesThePlaceOfWhatALinkLeadsTo)
{
    const TemporaryFolder folder;
    write_file(folder.file("in/real.bin"), "before");
    fs::create_symlink("in/real.bin", folder.file("link.bin"));
    GrowingFile file(folder.file("link.bin"));
    file.append("after");
    file.finish();
    EXPECT_TRUE(fs::is_symlink(folder.file("link.bin")));
    EXPECT_EQ(read_text_file(folder.file("in/real.bin")), "after");
    EXPECT_THAT(names_in(folder), ElementsAre("in", "link.bin"));
}

TEST(GrowingFile, TakesNoPlaceOfAFolderAPipeOrADevice)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    for (const std::string& path :
         {folder.path().string(), folder.file("pipe"), std::string("/dev/full")})
        EXPECT_THAT([&] { GrowingFile file(path); },
                    ThrowsMessage<Rejected>(HasSubstr(path + ": this is a ")));
    EXPECT_THAT([&] { GrowingFile file(folder.file("none/a.bin")); },
                ThrowsMessage<Rejected>(HasSubstr("cannot be written (No such file")));
    EXPECT_THAT(names_in(folder), ElementsAre("pipe"));
}

} // namespace
} // namespace trivar
