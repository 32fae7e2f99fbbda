// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "editor/commands/adjustment.h"

#include "editor/actions/actions.h"
#include "editor/actions/key_presets.h"
#include "editor/actions/palette_entries.h"
#include "editor/actions/use_keys.h"
#include "tests/editor/rig.h"
#include "tests/editor/shared_keys.h"

#include <gmock/gmock.h>
#include <set>

namespace trivar {
namespace {

using testing::Rig;

TEST(Adjustment, OfTheLastStepIsOneStepFromWhereItBegan)
{
    Rig rig;
    rig.two_objects();
    rig.editor.session.run(SetTransform{2, {.translation = {1, 0, 0}}});
    rig.frames();
    ASSERT_EQ(rig.editor.adjustment.step, 3u);
    for (const double x : {2.0, 3.0})
        propose_instead(rig.editor.adjustment, rig.editor.session,
                        SetTransform{2, {.translation = {x, 0, 0}}});
    finish_adjusting(rig.editor.adjustment, rig.editor.session, false);
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(object(rig.editor.session.committed(), 2).transform.translation.x, 3);
    rig.editor.session.undo();
    EXPECT_EQ(object(rig.editor.session.committed(), 2).transform.translation.z, 1);
}

TEST(Adjustment, CancelledLeavesTheStepAsItWas)
{
    Rig rig;
    rig.two_objects();
    rig.editor.session.run(Duplicate{{2}, {1, 0, 0}});
    rig.frames();
    rig.editor.session.selected = 3;
    propose_instead(rig.editor.adjustment, rig.editor.session, Duplicate{{2}, {5, 0, 0}});
    EXPECT_EQ(rig.editor.session.selected, 3);
    finish_adjusting(rig.editor.adjustment, rig.editor.session, true);
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(object(rig.editor.session.committed(), 3).transform.translation.x, 1);
    EXPECT_EQ(rig.editor.session.selected, 3);
}

TEST(Adjustment, IsOfferedForAStepJustMadeAndNotAfterGoingBack)
{
    Rig rig;
    rig.two_objects();
    rig.editor.session.run(AddSphere{});
    rig.frames();
    EXPECT_EQ(rig.editor.adjustment.step, 3u);
    rig.key({ui::key_f1 + 8});
    EXPECT_TRUE(rig.editor.adjustment.open);
    rig.editor.session.undo();
    rig.frames();
    EXPECT_EQ(rig.editor.adjustment.step, 0u);
    rig.editor.session.run(Rename{1, "Floor"});
    rig.frames();
    EXPECT_EQ(rig.editor.adjustment.step, 0u) << "a name is no number";
}

TEST(Repeating, MovesWhatIsSelectedAsFarAgain)
{
    Rig rig;
    rig.two_objects();
    rig.editor.session.run(SetTransform{2, {.translation = {1, 0, 1}}});
    rig.editor.session.selected = 1;
    rig.key({.key = 'R', .shift = true});
    EXPECT_EQ(object(rig.editor.session.committed(), 1).transform.translation, glm::dvec3(1, 0, 0));
}

TEST(KeyPresets, NameActionsThatThereAreAndGiveNoKeyTwice)
{
    Rig rig;
    for (const KeyPreset& preset : key_presets()) {
        for (const auto& [name, keys] : preset.keys) EXPECT_EQ(action(rig.editor, name).name, name);
        std::vector<Action> actions = rig.editor.actions;
        use_keys(actions, preset.keys);
        EXPECT_THAT(testing::shared_keys(actions), ::testing::IsEmpty()) << preset.name;
    }
}

TEST(Keyboard, FindsEveryActionInThePalette)
{
    Rig rig;
    std::set<std::string> found;
    for (const PaletteEntry& each : palette_commands(rig.editor)) found.insert(each.action);
    for (const Action& each : rig.editor.actions)
        if (each.name != palette_action) {
            EXPECT_TRUE(found.contains(each.name)) << each.name;
        }
}

TEST(Keyboard, F6GoesFromPanelToPanelAndEscapeClimbsOut)
{
    using Panel = Editor::Panel;
    Rig rig;
    rig.two_objects();
    rig.key({ui::key_f1 + 5});
    EXPECT_EQ(rig.editor.panel, Panel::outliner);
    rig.key({ui::key_up});
    EXPECT_EQ(rig.editor.session.selected, 1);
    rig.key({ui::key_f1 + 5});
    EXPECT_EQ(rig.editor.panel, Panel::dock);
    rig.key({ui::key_tab});
    rig.type("2");
    rig.key({ui::key_enter});
    EXPECT_EQ(object(rig.editor.session.committed(), 1).transform.translation.x, 2);
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.editor.panel, Panel::view);
}

} // namespace
} // namespace trivar
