// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/use_keys.h"

#include "editor/actions/actions.h"
#include "editor/actions/all_actions.h"
#include "editor/preferences/renamed_actions.h"
#include "tests/editor/rig.h"
#include "tests/editor/shared_keys.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig, ui::Chord;

TEST(KeyMap, NoTwoActionsShareAKeyInOnePlace)
{
    const Editor editor([] {}, all_actions());
    EXPECT_THAT(testing::shared_keys(editor.actions), IsEmpty());
}

TEST(KeyMap, RenamedActionsAreThereByTheirNewNamesAlone)
{
    const Editor editor([] {}, all_actions());
    const auto is_there = [&](std::string_view name) {
        return std::ranges::find(editor.actions, name, &Action::name) != editor.actions.end();
    };
    for (const auto& [old_name, now] : renamed_actions()) {
        EXPECT_FALSE(is_there(old_name)) << old_name;
        EXPECT_TRUE(is_there(now)) << now;
    }
}

TEST(KeyMap, ATutorialKeepsItsArrowsWhenFramesGetOthers)
{
    Editor editor([] {}, all_actions());
    EXPECT_THAT(give_key(editor.actions, "Next frame", {ui::key_left}),
                ElementsAre("Previous frame"));
    EXPECT_EQ(key_text(action(editor, "Step back")), "Left");
}

TEST(KeyMap, EveryKeyComesBackFromItsText)
{
    for (int key = 33; key < ui::key_count; ++key) {
        const Chord chord{.key = key, .ctrl = key % 2 == 0, .shift = key % 3 == 0, .alt = true};
        if (ui::caps_of(chord).back().empty()) continue;
        EXPECT_EQ(ui::chord_from(ui::text_of(chord)), chord) << ui::text_of(chord);
    }
    EXPECT_EQ(ui::chord_from(""), std::nullopt);
    EXPECT_EQ(ui::chord_from("Ctrl+"), std::nullopt);
    EXPECT_EQ(ui::chord_from("Ctrl+nonsense"), std::nullopt);
}

TEST(KeyMap, AGivenKeyIsTakenFromTheActionThatHadIt)
{
    Editor editor([] {}, all_actions());
    const Chord undo = action(editor, "Undo").keys.front();
    EXPECT_THAT(give_key(editor.actions, "Delete", undo), ElementsAre("Undo"));
    EXPECT_THAT(action(editor, "Delete").keys, ElementsAre(undo));
    EXPECT_THAT(action(editor, "Undo").keys, IsEmpty());
    EXPECT_THAT(give_usual_keys(editor.actions, "Undo"), ElementsAre("Delete"));
    EXPECT_THAT(action(editor, "Undo").keys, ElementsAre(undo));
}

TEST(KeyMap, HoldsOnlyWhatWasChangedAndBringsItBack)
{
    Editor editor([] {}, all_actions());
    EXPECT_THAT(changed_keys(editor.actions), IsEmpty());
    give_key(editor.actions, "Undo", {.key = 'U', .alt = true});
    KeyMap map = changed_keys(editor.actions);
    EXPECT_EQ(map.size(), 1u);
    map["An action that is gone"] = {{'Y'}};
    Editor other([] {}, all_actions());
    use_keys(other.actions, map);
    EXPECT_EQ(key_text(action(other, "Undo")), "Alt+U");
    use_keys(other.actions, {});
    EXPECT_EQ(key_text(action(other, "Undo")), "Ctrl+Z");
}

TEST(KeyMap, GivesAUsualKeyToNobodyWhereItWasGivenAway)
{
    Editor editor([] {}, all_actions());
    use_keys(editor.actions, {{"Undo", {{'G'}}}}); // Move's
    EXPECT_EQ(key_text(action(editor, "Undo")), "G");
    EXPECT_EQ(key_text(action(editor, "Move")), "");
}

TEST(KeyMap, IsWhatHintsName)
{
    Editor editor([] {}, all_actions());
    const Hint hint{{"Shift", "@Move"}, "Move"};
    EXPECT_THAT(inputs_now(editor, hint), ElementsAre("Shift", "G"));
    give_key(editor.actions, "Move", {'J'});
    EXPECT_THAT(inputs_now(editor, hint), ElementsAre("Shift", "J"));
    use_keys(editor.actions, {{"Move", {}}});
    EXPECT_THAT(inputs_now(editor, hint), IsEmpty());
}

TEST(KeyMap, HintsSayWhatATrackpadNeedsToZoom)
{
    Editor editor([] {}, all_actions());
    const Hint zoom{{"wheel"}, "Zoom"};
    EXPECT_THAT(inputs_now(editor, zoom), ElementsAre("wheel"));
    editor.preferences.mouse.device = "trackpad";
    EXPECT_THAT(inputs_now(editor, zoom), ElementsAre("Ctrl", "wheel"));
}

TEST(KeyMap, IsChangedByPressingTheNewKey)
{
    Rig rig;
    rig.editor.preferences_dialog.open = true;
    rig.editor.preferences_dialog.page = rig.editor.preferences_dialog.of_keys;
    rig.editor.preferences_dialog.asking = "Frame all";
    rig.frames();
    rig.key({.key = 'J', .shift = true});
    EXPECT_EQ(key_text(action(rig.editor, "Frame all")), "Shift+J");
    EXPECT_EQ(rig.editor.preferences.keys.size(), 1u);
    EXPECT_TRUE(rig.editor.preferences_dialog.asking.empty());
    rig.editor.preferences_dialog.asking = "Frame all";
    rig.frames();
    rig.key({.key = ui::key_escape}); // leaves the key, and the dialog open
    EXPECT_EQ(key_text(action(rig.editor, "Frame all")), "Shift+J");
    EXPECT_TRUE(rig.editor.preferences_dialog.open);
    rig.key({.key = ui::key_escape});
    EXPECT_FALSE(rig.editor.preferences_dialog.open);
}

} // namespace
} // namespace trivar
