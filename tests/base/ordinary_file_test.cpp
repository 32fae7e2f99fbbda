// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/ordinary_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "tests/support/fixtures.h"

#include <array>
#include <filesystem>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::ThrowsMessage;

TEST(OrdinaryFile, GivesItsBytesInPiecesUpToItsEnd)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("a"), "seven b");
    OrdinaryFile file(folder.file("a"));
    EXPECT_EQ(file.size(), 7u);
    std::array<char, 4> four{};
    EXPECT_EQ(file.read(four), 4u);
    EXPECT_EQ(file.read(four), 3u);
    EXPECT_EQ(file.read(four), 0u);
    EXPECT_EQ(read_file(folder.file("a"), 7), "seven b");
    EXPECT_THAT([&] { read_file(folder.file("a"), 6); },
                ThrowsMessage<Rejected>(HasSubstr("has 7 bytes, more than the 6 allowed")));
}

TEST(OrdinaryFile, RefusesAtOnceWhatWouldWaitOrNeverEnd)
{
    const testing::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink(folder.file("pipe"), folder.file("link"));
    const auto refuses = [](const std::string& path, const char* words) {
        EXPECT_THAT([&] { OrdinaryFile file(path); },
                    ThrowsMessage<Rejected>(HasSubstr(path + ": " + words)));
        EXPECT_THAT([&] { read_text_file(path); }, ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refuses(folder.file("pipe"), "this is a pipe, not an ordinary file");
    refuses(folder.file("link"), "this is a pipe, not an ordinary file");
    refuses("/dev/zero", "this is a device, not an ordinary file");
    refuses(folder.path().string(), "this is a folder, not an ordinary file");
    refuses(folder.file("none"), "there is no such file");
}

TEST(OrdinaryFile, IsAllThatAFileTakesThePlaceOf)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("a"), "a");
    EXPECT_NO_THROW(check_replaceable(folder.file("a")));
    EXPECT_NO_THROW(check_replaceable(folder.file("none")));
    for (const std::string& path : {folder.path().string(), std::string("/dev/full")})
        EXPECT_THAT(
            [&] { check_replaceable(path); },
            ThrowsMessage<Rejected>(HasSubstr("not an ordinary file, so it is not replaced")));
}

} // namespace
} // namespace trivar
