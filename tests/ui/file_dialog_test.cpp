// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"
#include "ui/file_dialog.h"
#include "ui/headless.h"
#include "ui/keys.h"

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

// A dialog of a folder with one file, in frames without a screen.
struct Dialog {
    explicit Dialog(const FileRequest& request)
    {
        std::ofstream(folder.file("a.obj")) << "old";
        dialog.open(request, folder.path());
        frames();
    }
    const testing::TemporaryFolder folder;
    HeadlessFrames screen{{720, 600}};
    FileDialog dialog;
    std::optional<std::string> chosen;

    void frames()
    {
        screen.frames(4, [this](Frame& frame) {
            if (auto path = dialog.draw(frame.theme)) chosen = path;
        });
    }
    void key(int code)
    {
        screen.input().push(press_key(code));
        screen.input().push(press_key(code, false));
        frames();
    }
};
const FileRequest saving{
    .title = "Save", .action = "Save", .extensions = {".obj"}, .saving = true, .name = "a.obj"};

TEST(FileDialog, TabWalksToItsButtonsAndBack)
{
    Dialog d(saving);
    d.key(key_enter);
    EXPECT_FALSE(d.chosen) << "Enter alone replaces nothing";
    for (int i = 0; i < 5; ++i) d.key(key_tab); // once round and on to the button
    d.key(key_enter);
    ASSERT_TRUE(d.chosen);
    EXPECT_EQ(*d.chosen, d.folder.file("a.obj"));
    EXPECT_FALSE(d.dialog.is_open());
}

// Returns the folder that Enter chooses if that name is suggested.
std::optional<std::string> folder_of_name(const std::string& name)
{
    Dialog d({.title = "Folder",
              .action = "Choose",
              .extensions = {},
              .saving = true,
              .folder = true,
              .name = name});
    d.key(key_enter);
    EXPECT_EQ(d.dialog.is_open(), !d.chosen);
    if (!d.chosen) return std::nullopt;
    return std::filesystem::path(*d.chosen).lexically_relative(d.folder.path()).string();
}

TEST(FileDialog, ForAFolderTakesOneThatIsThereOrIsNotYet)
{
    EXPECT_EQ(folder_of_name(""), ".");
    EXPECT_EQ(folder_of_name("frames"), "frames");
    EXPECT_EQ(folder_of_name("a.obj"), std::nullopt) << "that is a file";
}

TEST(FileDialog, IsLeftByTheButtonThatSaysSo)
{
    Dialog d(saving);
    d.key(key_tab);
    d.key(key_space);
    EXPECT_FALSE(d.chosen);
    EXPECT_FALSE(d.dialog.is_open());
}

TEST(FileDialog, TakesNamesOfScannersThatHaveNoEnding)
{
    const auto chosen = [](const std::string& name) {
        Dialog d({.title = "Import", .action = "Import", .extensions = {".dcm"}, .name = {}});
        for (const char* each : {"1.2.840.7", "IM0001", "notes.txt"})
            testing::write_file(d.folder.file(each), "x");
        for (const char letter : name)
            d.screen.input().push(type_text(static_cast<unsigned char>(letter)));
        d.frames();
        d.key(key_enter);
        return d.chosen.has_value();
    };
    EXPECT_TRUE(chosen("1.2.840.7"));
    EXPECT_TRUE(chosen("IM0001"));
    EXPECT_FALSE(chosen("notes.txt"));
    EXPECT_FALSE(chosen("missing"));
}

TEST(FileDialog, HasACheckBoxThatTabReachesWhereTheRequestNamesOne)
{
    FileRequest request = saving;
    request.name = "b.obj";
    request.option = "Small";
    Dialog d(request);
    EXPECT_FALSE(d.dialog.option_on());
    d.key(key_tab);
    d.key(key_space);
    EXPECT_TRUE(d.dialog.option_on());
    d.key(key_tab);
    d.key(key_tab);
    d.key(key_enter);
    EXPECT_TRUE(d.chosen);
    EXPECT_TRUE(d.dialog.option_on());
}

TEST(FileDialog, AsksAgainWithWhatWasTyped)
{
    Dialog d({.title = "Save",
              .action = "Save",
              .extensions = {".obj"},
              .saving = true,
              .name = "b.obj"});
    d.key(key_enter);
    ASSERT_TRUE(d.chosen);
    EXPECT_FALSE(d.dialog.is_open());
    const std::string first = *d.chosen;
    d.chosen.reset();
    d.dialog.ask_again("The disk is full.");
    d.frames();
    EXPECT_TRUE(d.dialog.is_open());
    d.key(key_enter);
    EXPECT_EQ(d.chosen, first);
}

TEST(FileDialog, AsksAgainInTheFolderThatItListed)
{
    Dialog d({.title = "Save",
              .action = "Save",
              .extensions = {".obj"},
              .saving = true,
              .name = "inner/b.obj"});
    std::filesystem::create_directories(d.folder.path() / "inner");
    for (int i = 0; i < 2; ++i) { // a name within the listed folder means the same each time
        d.key(key_enter);
        EXPECT_EQ(d.chosen, d.folder.file("inner/b.obj"));
        d.chosen.reset();
        d.dialog.ask_again("The disk is full.");
        d.frames();
    }
}

TEST(FileDialog, LetsTypingReplaceTheNameAndKeepItsExtension)
{
    Dialog d(saving);
    for (const unsigned letter : {'n', 'e', 'w'}) d.screen.input().push(type_text(letter));
    d.frames();
    d.key(key_enter);
    EXPECT_EQ(d.chosen, d.folder.file("new.obj"));
}

TEST(FileDialog, TakesWhatIsTypedAfterAFolderWasEnteredByADoubleClick)
{
    Dialog d({.title = "Open", .action = "Open", .extensions = {".obj"}, .name = {}});
    std::filesystem::create_directory(d.folder.path() / "zoo");
    std::ofstream(d.folder.file("zoo/b.obj")) << "x";
    d.dialog.open({.title = "Open", .action = "Open", .extensions = {".obj"}, .name = {}},
                  d.folder.path());
    d.frames();
    d.screen.input().push(move_to({200, 142})); // the first row
    for (const bool down : {true, false, true, false})
        d.screen.input().push(press(Button::left, down));
    d.frames();
    d.frames();
    d.key(key_enter);
    EXPECT_FALSE(d.chosen) << "no row was chosen by the press that entered";
    for (const unsigned letter : {'b', '.', 'o', 'b', 'j'})
        d.screen.input().push(type_text(letter));
    d.frames();
    d.key(key_enter);
    EXPECT_EQ(d.chosen, d.folder.file("zoo/b.obj"));
}

} // namespace
} // namespace trivar::ui
