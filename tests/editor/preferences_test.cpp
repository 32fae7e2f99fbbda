// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences.h"

#include "core/base/text.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

TEST(Preferences, ComeBackFromTheirText)
{
    Preferences p;
    p.scale = 1.25;
    p.dock = 400;
    p.show_dock = false;
    p.backdrop_as_in_pictures = true;
    p.quality = "high";
    p.deform = "two_phases";
    p.timeline = 240;
    p.timeline_open = true;
    p.loop = false;
    p.recent_commands = {"Box", "Save as..."};
    p.keys = {{"Undo", {{.key = 'U', .ctrl = true}}}, {"Redo", {}}};
    EXPECT_EQ(preferences_from(text_of(p)), p);
}

TEST(Preferences, AreAsIfNewWhereTheTextIsOdd)
{
    for (const std::string text :
         {"", "no JSON", "[1,2]", "{", R"({"scale":"big","dock":null,"show_dock":3})",
          R"({"quality":"best"})", R"({"quality":7})", R"({"deform":"magic"})",
          R"({"recent_commands":[1,{"a":2},null]})", R"({"dock":1e999})",
          R"({"keys":[{"Undo":3}]})", R"({"keys":{"Undo":"Ctrl+Z"}})", "\xFF\xFE{}"})
        EXPECT_EQ(preferences_from(text), Preferences()) << text;
    EXPECT_EQ(preferences_from(std::string(200000, '[')), Preferences());
    const std::string nested =
        R"({"a":)" + std::string(100000, '[') + std::string(100000, ']') + "}";
    EXPECT_EQ(preferences_from(nested), Preferences());
}

TEST(Preferences, OutOfRangeAreCutToIt)
{
    const Preferences p = preferences_from(R"({"scale":99,"dock":-5,"outliner":1})");
    EXPECT_EQ(p.scale, 2);
    EXPECT_EQ(p.dock, 280);
    EXPECT_EQ(p.outliner, 120);
    std::string many = R"({"recent_scenes":["x")";
    for (int i = 0; i < 1000; ++i) many += ",\"y\"";
    EXPECT_LE(preferences_from(many + "]}").recent_scenes.size(), 16u);
}

TEST(Preferences, AreWrittenWhenTheyChangeAndReadAgain)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("deep/er/preferences.json");
    PreferencesFile file(path);
    EXPECT_EQ(file.keep({}), "");
    EXPECT_FALSE(std::filesystem::exists(path));
    Preferences p;
    p.outliner = 300;
    p.look = {.light = true, .other_hues = true};
    EXPECT_EQ(file.keep(p), "");
    EXPECT_EQ(PreferencesFile(path).read(), p);
    EXPECT_EQ(read_text_file(path), text_of(p));
}

TEST(Preferences, ThatCannotBeWrittenSaySoOnce)
{
    const testing::TemporaryFolder folder;
    std::ofstream(folder.file("file")) << "in the way";
    PreferencesFile file(folder.file("file/preferences.json"));
    Preferences p;
    p.dock = 300;
    EXPECT_THAT(file.keep(p), ::testing::HasSubstr("cannot be written"));
    p.dock = 310;
    EXPECT_EQ(file.keep(p), "");
}

TEST(Preferences, RememberTheNewestFirstAndOnce)
{
    std::vector<std::string> recent{"a", "b"};
    remember(recent, "b");
    EXPECT_EQ(recent, (std::vector<std::string>{"b", "a"}));
}

TEST(Preferences, TheScaleGoesUpAndDownBetweenItsEnds)
{
    EXPECT_EQ(next_scale(1, 1), 1.1);
    EXPECT_EQ(next_scale(1, -1), 0.9);
    EXPECT_EQ(next_scale(2, 1), 2);
    EXPECT_EQ(next_scale(0.75, -1), 0.75);
    EXPECT_EQ(next_scale(1.03, -1), 1);
}

} // namespace
} // namespace trivar
