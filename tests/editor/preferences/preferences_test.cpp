// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences/preferences.h"

#include "core/base/text.h"
#include "editor/words/file_words.h"
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
    p.library_tiles = {"/models/rope.glb"};
    p.at_start = "last";
    p.ask_to_keep = p.grid = p.show_axes = p.show_timing = false;
    p.pace = "30";
    p.view_tolerance = "0.5";
    p.threads = 3;
    p.mouse = {"trackpad", "space", "origin", false, true, 0.5, 2, 3};
    p.discarded_days = 90;
    p.most_recent = 4;
    p.scenes_folder = "~/scenes";
    p.models_folder = "/models";
    p.look = {.high_contrast = true,
              .lines = 1.5,
              .tooltip_s = 2,
              .double_click_s = 0.8,
              .click_holds = true};
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

TEST(Preferences, AreReadWithTheNamesOfWhatIsOdd)
{
    using ::testing::ElementsAre, ::testing::IsEmpty;
    EXPECT_THAT(read_preferences(text_of({})).odd, IsEmpty());
    EXPECT_THAT(read_preferences("{}").odd, IsEmpty());
    EXPECT_THAT(read_preferences(R"({"of a later program":1})").odd, IsEmpty());
    EXPECT_THAT(read_preferences(R"({"scale":99,"pace":"never","threads":-1,"grid":0})").odd,
                ElementsAre("scale", "grid", "pace", "threads"));
    EXPECT_THAT(read_preferences("no JSON").odd, ElementsAre("the whole file"));
}

TEST(Preferences, NameTheListsInWhichSomethingIsOdd)
{
    using ::testing::ElementsAre;
    const ReadPreferences read = read_preferences(
        R"({"keys":{"Undo":["Ctrl+U","Hyper+U"],"Redo":"R","Copy":["Ctrl+C"],"Cut":[]},
            "recent_scenes":["a",7,"b"],"closed_hints":["x"]})");
    EXPECT_THAT(read.odd, ElementsAre("keys, Redo", "keys, Undo", "recent_scenes"));
    EXPECT_THAT(read.preferences.recent_scenes, ElementsAre("a", "b"));
    EXPECT_EQ(read.preferences.keys.at("Undo").size(), 1u);
    EXPECT_EQ(read.preferences.keys.count("Redo"), 0u) << "its usual keys";
}

TEST(Preferences, GiveKeysOfAnActionThatWasRenamedToTheOneThatItIsNow)
{
    const ReadPreferences read = read_preferences(
        R"({"keys":{"See through":["Ctrl+J"],"Select nothing":["U"],"Deselect all":["Y"]}})");
    EXPECT_THAT(read.odd, ::testing::IsEmpty());
    const KeyMap expected{{"X-ray", {{.key = 'J', .ctrl = true}}}, {"Deselect all", {{'Y'}}}};
    EXPECT_EQ(read.preferences.keys, expected) << "the newer name says more";
}

TEST(Preferences, ThatCannotBeReadStayAsTheyAre)
{
    const testing::TemporaryFolder folder; // a folder cannot be read as a file, by nobody
    const std::string path = folder.file("preferences.json");
    std::filesystem::create_directory(path);
    PreferencesFile file(path);
    EXPECT_EQ(file.read(), Preferences());
    EXPECT_THAT(file.trouble(), ::testing::HasSubstr("cannot be read"));
    Preferences p;
    p.dock = 300;
    EXPECT_EQ(file.keep(p), "");
    EXPECT_TRUE(std::filesystem::is_directory(path));
    EXPECT_FALSE(std::filesystem::exists(path + ".odd"));
}

TEST(Preferences, OfAFileThatIsNoneAreTheUsualOnesAndTheFileIsKept)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("preferences.json");
    testing::write_file(path, "{ torn");
    PreferencesFile file(path);
    EXPECT_EQ(file.read(), Preferences());
    EXPECT_THAT(file.trouble(), ::testing::HasSubstr("cannot be understood"));
    EXPECT_EQ(read_text_file(path + ".odd"), "{ torn");
    testing::write_file(path, "{ torn again");
    EXPECT_THAT(PreferencesFile(path).trouble(), ::testing::HasSubstr("preferences.json.odd2"));
    EXPECT_EQ(read_text_file(path + ".odd"), "{ torn");
    EXPECT_EQ(read_text_file(path + ".odd2"), "{ torn again");
    testing::write_file(path, R"({"orbit_speed":1e9,"zoom_speed":"x"})");
    EXPECT_THAT(PreferencesFile(path).trouble(), ::testing::HasSubstr("orbit_speed and 1 more"));
    EXPECT_EQ(PreferencesFile(folder.file("none")).trouble(), "");
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

TEST(Preferences, TellDaysAsPeopleDo)
{
    EXPECT_EQ(for_days(1), "for a day");
    EXPECT_EQ(for_days(30), "for 30 days");
    EXPECT_EQ(for_days(365), "for a year");
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
