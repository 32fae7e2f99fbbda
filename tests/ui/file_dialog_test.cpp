// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"
#include "ui/file_dialog.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names(const std::vector<FileEntry>& entries)
{
    std::vector<std::string> result;
    for (const FileEntry& entry : entries) result.push_back(entry.name);
    return result;
}

TEST(FileDialog, ListsFoldersFirstThenFilesAsPeopleCount)
{
    const testing::TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "zoo");
    for (const char* name : {"model10.OBJ", "model2.obj", "Alpha.obj", "notes.txt", ".hidden.obj"})
        std::ofstream(folder.file(name)) << "x";
    EXPECT_THAT(names(entries_of(folder.path(), {".obj"})),
                ElementsAre("zoo", "Alpha.obj", "model2.obj", "model10.OBJ"));
}

TEST(FileDialog, AFolderThatCannotBeReadIsEmpty)
{
    EXPECT_TRUE(entries_of("/no/such/folder", {}).empty());
}

TEST(FileDialog, NaturalOrderComparesRunsOfDigitsAsNumbers)
{
    EXPECT_TRUE(natural_less("a9b", "a10a"));
    EXPECT_TRUE(natural_less("a007", "a8"));
    EXPECT_TRUE(natural_less("b", "C"));
    EXPECT_TRUE(natural_less("a", "a1"));
    EXPECT_FALSE(natural_less("a1", "a"));
    EXPECT_FALSE(natural_less("same", "same"));
}

} // namespace
} // namespace trivar::ui
