// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/palette_entries.h"

#include "editor/actions/actions.h"
#include "editor/actions/all_actions.h"
#include "editor/actions/palette_search.h"
#include "editor/actions/show_manual.h"
#include "editor/editor.h"
#include "editor/words/letters_in_order.h"
#include "editor/words/ranked.h"
#include "editor/words/synonyms.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;

std::vector<std::string> found(std::string_view letters, const std::vector<std::string>& names,
                               const std::vector<std::string>& recent = {})
{
    std::vector<std::string> result;
    for (const RankedName& each : ranked(letters, names, recent))
        result.push_back(names[each.index]);
    return result;
}

TEST(LettersInOrder, AreFoundWhateverLiesBetweenAndWhateverTheirCase)
{
    EXPECT_TRUE(letters_in_order("svc", "Save compact..."));
    EXPECT_TRUE(letters_in_order("SAVE AS", "Save as..."));
    EXPECT_FALSE(letters_in_order("cs", "Save compact"));
    EXPECT_FALSE(letters_in_order("saves", "Save"));
    EXPECT_TRUE(letters_in_order("", "anything"));
    EXPECT_FALSE(letters_in_order("a", ""));
    EXPECT_TRUE(letters_in_order(std::string(5000, 'a'), std::string(5000, 'a')));
}

TEST(LettersInOrder, PreferBeginningsOfWordsAndLettersSideBySide)
{
    EXPECT_THAT(letters_in_order("sc", "Discs, Save compact")->at, ElementsAre(7, 12));
    EXPECT_THAT(letters_in_order("com", "c o m com")->at, ElementsAre(6, 7, 8));
    EXPECT_GT(letters_in_order("un", "Undo")->score,
              letters_in_order("un", "Ungroup s")->score - 1);
    EXPECT_GT(letters_in_order("box", "Add Box")->score,
              letters_in_order("box", "Bookmark x")->score);
}

TEST(RankedName, PutsTheBestMatchFirst)
{
    EXPECT_THAT(found("sa", {"Use as", "Save as...", "Frame selection"}),
                ElementsAre("Save as...", "Use as"));
    EXPECT_THAT(found("hide", {"Hide or show", "Hide"}), ElementsAre("Hide", "Hide or show"));
    EXPECT_THAT(found("xyz", {"Save"}), IsEmpty());
}

TEST(RankedName, PutsTheRecentOnesFirstWithoutLettersAndAmongEqualMatches)
{
    const std::vector<std::string> names{"New", "Open", "Undo", "Redo"};
    EXPECT_THAT(found("", names, {"Redo", "Gone", "Open"}),
                ElementsAre("Redo", "Open", "New", "Undo"));
    EXPECT_THAT(found("do", {"Undo", "Redo"}, {"Redo"}), ElementsAre("Redo", "Undo"));
    const auto all = ranked("", names, {"Open"});
    EXPECT_TRUE(all[0].recent);
    EXPECT_FALSE(all[1].recent);
}

TEST(RankedName, PutsLettersThatStandNearTogetherBeforeScatteredOnesAmongEqualMatches)
{
    const std::vector<std::string> names{"Save numbered copy", "Save compact...", "Save a copy"};
    EXPECT_THAT(found("svc", names),
                ElementsAre("Save compact...", "Save a copy", "Save numbered copy"));
    EXPECT_THAT(found("svc", names, {"Save numbered copy"}),
                ElementsAre("Save numbered copy", "Save compact...", "Save a copy"));
}

std::vector<std::string> found_in_palette(std::string_view typed)
{
    const Editor editor([] {}, all_actions());
    const std::vector<PaletteEntry> entries = palette_commands(editor);
    std::vector<std::string> names;
    for (const RankedName& each : found_entries(typed, entries, {}))
        names.push_back(entries[each.index].name);
    return names;
}

TEST(PaletteSearch, KnowsNothingButNamesOfThePaletteUnderTheWordsOfArtists)
{
    const Editor editor([] {}, all_actions());
    std::set<std::string, std::less<>> names;
    for (const PaletteEntry& each : palette_commands(editor)) names.insert(each.name);
    std::string_view before;
    for (const Synonym& each : synonyms()) {
        EXPECT_LT(before, each.word) << "the table is in alphabetical order";
        before = each.word;
        for (const std::string_view name : each.names)
            EXPECT_TRUE(names.contains(name)) << each.word << ": " << name;
    }
}

TEST(PaletteSearch, FindsWhatArtistsCallByAnotherWordAtOnce)
{
    for (const auto& [typed, first] :
         std::vector<std::pair<std::string, std::string>>{{"light", "Picture settings"},
                                                          {"sun", "Picture settings"},
                                                          {"mirror", "Transform"},
                                                          {"array", "Set travel"},
                                                          {"opacity", "Set material"},
                                                          {"orthographic", "Perspective"},
                                                          {"ffd", "Add Lattice round selection"},
                                                          {"cage", "Add Lattice round selection"},
                                                          {"bake", "Export frames..."},
                                                          {"Snap", "Place"},
                                                          {"texture", "Set material"},
                                                          {"video", "Record..."},
                                                          {"flap", "Incise"},
                                                          {"section", "Incise"},
                                                          {"svg", "Export..."},
                                                          {"dicom", "Import model..."},
                                                          {"paper", "Picture settings"},
                                                          {"iso-surface", "Silhouettes"},
                                                          {"slice", "Split"},
                                                          {"measure", "Timing"}}) {
        const std::vector<std::string> names = found_in_palette(typed);
        ASSERT_FALSE(names.empty()) << typed;
        EXPECT_EQ(names.front(), first) << typed;
    }
}

TEST(PaletteSearch, PutsNamesBeforeWordsOfDescriptionsAndTakesNoLettersFromThese)
{
    EXPECT_EQ(found_in_palette("export").front(), "Export...");
    EXPECT_EQ(found_in_palette("svc").front(), "Save camera");
    EXPECT_THAT(found_in_palette("xqzj"), IsEmpty());
    const std::vector<std::string> names = found_in_palette("back");
    EXPECT_EQ(names.front(), "Back");
}

TEST(CommandPalette, HoldsEveryActionAndSaysWhyOneCannotRun)
{
    const Editor editor([] {}, all_actions());
    const std::vector<PaletteEntry> entries = palette_commands(editor);
    std::set<std::string> names;
    for (const PaletteEntry& each : entries)
        EXPECT_TRUE(names.insert(each.name).second) << each.name << " stands there twice";
    for (const Action& each : editor.actions) {
        if (each.name == palette_action) continue;
        EXPECT_TRUE(names.contains(each.name) || names.contains("Add " + each.name)) << each.name;
        EXPECT_EQ(each.enabled.holds != nullptr, !each.enabled.otherwise.empty())
            << each.name << " does not say what is missing";
    }
    EXPECT_TRUE(names.contains("Set material"));
}

TEST(CommandPalette, OpensByItsKeysAndRunsWhatWasFound)
{
    testing::Rig rig;
    rig.frames();
    rig.key({.key = ui::key_f1 + 2});
    EXPECT_TRUE(rig.editor.palette.open);
    rig.key({.key = ui::key_f1 + 2});
    EXPECT_FALSE(rig.editor.palette.open);
    rig.key({.key = 'P', .ctrl = true, .shift = true});
    rig.type("addbox");
    rig.key({.key = ui::key_enter});
    EXPECT_FALSE(rig.editor.palette.open);
    EXPECT_EQ(rig.steps(), 1u);
    EXPECT_EQ(rig.editor.preferences.recent_commands.front(), "Add Box");
}

TEST(CommandPalette, FindsByTheMenuWhatHasNoSuchName)
{
    testing::Rig rig;
    rig.frames();
    rig.key({.key = 'P', .ctrl = true, .shift = true});
    rig.type("help");
    rig.key({.key = ui::key_enter});
    EXPECT_TRUE(rig.editor.memory.of<ManualDialog>().open);
}

TEST(CommandPalette, ChangesAPreferenceAfterAColon)
{
    testing::Rig rig;
    rig.frames();
    rig.key({.key = 'P', .ctrl = true, .shift = true});
    rig.type(":reduced");
    rig.key({.key = ui::key_enter});
    EXPECT_TRUE(rig.editor.preferences.reduced_motion);
    EXPECT_TRUE(rig.editor.preferences.recent_commands.empty());
}

TEST(CommandPalette, LeadsToTheKeyOfACommand)
{
    testing::Rig rig;
    rig.frames();
    rig.key({.key = 'P', .ctrl = true, .shift = true});
    rig.type("frameall");
    rig.key({.key = ui::key_enter, .alt = true});
    EXPECT_TRUE(rig.editor.preferences_dialog.open);
    EXPECT_EQ(rig.editor.preferences_dialog.asking, "Frame all");
}

} // namespace
} // namespace trivar
